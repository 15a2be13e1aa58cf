# Builds for AArch64 on another processor, and runs what is built by qemu: with the packages that
# `scripts/install-dependencies aarch64` installs. See scripts/aarch64.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64;-L;/usr/aarch64-linux-gnu)
