#!/usr/bin/env bash
# Runs a command with --postgis behind it, beside a PostGIS server that it starts for it, in a
# temporary folder. Without PostGIS, runs the command as it is.
#
#   with_postgis.sh <command> [<argument>]...
#
# psql finds the server by the variables of its environment. The server answers no one but this
# machine's users, and has one thread for each query. It does not run as root, but as its own user.
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail

bin=$(ls -d /usr/lib/postgresql/*/bin 2> /dev/null | sort -V | tail -1) || true
if [[ ! -x $bin/initdb || ! -e $("$bin"/pg_config --sharedir)/extension/postgis.control ]]; then
  echo "PostGIS is left out (Debian: postgresql, postgresql-postgis)" >&2
  exec "$@"
fi

folder=$(mktemp -d)
as_server() { "$@"; }
if [[ $EUID -eq 0 ]]; then
  chown postgres "$folder"
  as_server() { setpriv --reuid=postgres --regid=postgres --clear-groups "$@"; }
fi
stop() {
  as_server "$bin"/pg_ctl stop --pgdata="$folder"/data --mode=immediate > /dev/null || true
  rm -rf "$folder"
}
trap stop EXIT

cd /
as_server "$bin"/initdb --pgdata="$folder"/data --username=postgres --auth=trust --no-sync \
  > /dev/null
settings="-c listen_addresses= -c unix_socket_directories=$folder -c fsync=off"
settings+=" -c shared_buffers=1GB -c work_mem=256MB -c maintenance_work_mem=256MB"
settings+=" -c random_page_cost=1.1 -c max_parallel_workers_per_gather=0"
as_server "$bin"/pg_ctl start --wait --pgdata="$folder"/data --log="$folder"/log \
  --options="$settings" > /dev/null
cd "$OLDPWD"
export PGHOST=$folder PGUSER=postgres PGDATABASE=postgres
"$bin"/psql --quiet --command='CREATE EXTENSION postgis'
"$@" --postgis
