# Sourced at the beginning of a test: starts it again, with its arguments, in a network of its own in which multicast works.
# Exit code 77: no private network namespace may be made here.
if [ -z "${bus_is_private:-}" ]; then
  unshare -rn true 2>/dev/null || exit 77
  bus_is_private=yes exec unshare -rn "$0" "$@"
fi
ip link set lo up multicast on && ip route add 224.0.0.0/4 dev lo || exit 77
