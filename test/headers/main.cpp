// Linked with one object file per header: succeeds if nothing is defined twice.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

int main()
{
  return 0;
}
