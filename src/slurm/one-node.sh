#!/usr/bin/env bash
# Tries README's Slurm lines on a real Slurm: one node, on this machine, in a folder of its own.
#
#     one-node.sh JAR README SCENES FOLDER
#
# Starts munged (which signs Slurm's messages), slurmctld (which deals out jobs) and slurmd (which runs them), runs the
# lines as they stand in README, and compares the picture that they join with the one that one program draws. Ends the
# three by their process ids, also when something fails. Everything lies in FOLDER, logs included. Needs no root.
set -euo pipefail

fail() {
    echo "gradle slurm: $1" >&2
    exit 1
}

seconds=120   # the most that a step may take: only one that hangs takes so long

# Repeats a command until it succeeds; while it does not, the daemons must be alive.
until_true() {
    local what=$1 end=$((SECONDS + seconds))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || fail "$what: not within $seconds s; the logs are in $folder"
        for i in "${!pids[@]}"; do
            kill -0 "${pids[i]}" 2> /dev/null || fail "${names[i]} ended by itself; its log is $folder/${names[i]}.log"
        done
        sleep 0.2
    done
}

# Starts a daemon that stays in the foreground, as a child of this shell.
pids=() names=() lines_pid=
start() {
    local name=$1
    shift
    "$@" > "$folder/$name.out" 2>&1 &
    pids+=($!) names+=("$name")
}

# Ends README's lines, cancels what Slurm still runs, then ends the daemons, the last one first.
end_all() {
    local i end
    [ -z "$lines_pid" ] || kill "$lines_pid" 2> /dev/null || true
    if [ ${#pids[@]} -gt 1 ]; then
        scancel --quiet --user="$(id -un)" 2> /dev/null || true
        end=$((SECONDS + 20))
        while [ $SECONDS -lt $end ] && [ -n "$(squeue --noheader 2> /dev/null)" ]; do sleep 0.2; done
    fi
    for ((i = ${#pids[@]} - 1; i >= 0; i--)); do
        kill "${pids[i]}" 2> /dev/null || continue
        end=$((SECONDS + 20))
        while [ $SECONDS -lt $end ] && kill -0 "${pids[i]}" 2> /dev/null; do sleep 0.1; done
        kill -KILL "${pids[i]}" 2> /dev/null || true
    done
}

free_port() {
    local port=$1
    while (: < "/dev/tcp/127.0.0.1/$port") 2> /dev/null; do
        port=$((port + 1))
    done
    echo "$port"
}

[ $# -eq 4 ] || fail "expected JAR README SCENES FOLDER"
PATH=$PATH:/usr/sbin:/sbin
missing=$(for command in munged slurmctld slurmd sbatch sinfo java convert compare; do
    type "$command" > /dev/null 2>&1 || echo "$command"
done)
[ -z "$missing" ] || fail "not installed: $(echo $missing)
On Debian and Ubuntu: apt-get install slurm-wlm munge imagemagick"

jar=$(realpath "$1") readme=$(realpath "$2") scenes=$(realpath "$3")
rm -rf "$4"
mkdir -p "$4/state" "$4/spool" "$4/checkout/build/libs"
folder=$(realpath "$4")
trap end_all EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

socket=$folder/munge.socket
[ ${#socket} -le 107 ] || fail "$socket: a socket's name has at most 107 bytes; use a checkout with a shorter path"
[[ $folder != *' '* ]] || fail "$folder: Slurm's settings can hold no name with a space"
(umask 077 && head -c 1024 /dev/urandom > "$folder/munge.key")
start munged munged --foreground --force --key-file "$folder/munge.key" --socket "$socket" \
    --pid-file "$folder/munged.pid" --log-file "$folder/munged.log" --seed-file "$folder/munged.seed"
until_true "munged's socket" test -S "$socket"

host=$(hostname -s)
controller_port=$(free_port 16817)
node_port=$(free_port $((controller_port + 1)))
cat > "$folder/slurm.conf" << END
ClusterName=local
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$controller_port
SlurmdPort=$node_port
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP
END
export SLURM_CONF=$folder/slurm.conf
start slurmctld slurmctld -D -f "$SLURM_CONF" -L "$folder/slurmctld.log"
until_true "the controller's answer" eval 'sinfo > /dev/null 2>&1'
start slurmd slurmd -D -f "$SLURM_CONF" -L "$folder/slurmd.log"
until_true "a node without work" eval '[ "$(sinfo --noheader --format=%t 2> /dev/null)" = idle ]'
echo "Slurm $(slurmctld -V | cut -d' ' -f2) is up: 1 node, $(nproc) processors"

# A folder like a checkout, so that README's lines find what they name and leave nothing in the real one.
cd "$folder/checkout"
ln -s "$jar" build/libs/RayTracer.jar
ln -s "$scenes" scenes
lines=$(sed -n '/^<!-- job array: slurm -->$/,/^```$/p' "$readme" | sed '1,2d;$d')
[ -n "$lines" ] || fail "$readme: no lines after <!-- job array: slurm -->"
sed 's/^/+ /' <<< "$lines"
begun=$(date +%s%N)
timeout $((5 * seconds)) bash -e -c "$lines" &
lines_pid=$!   # waited for, since a shell that runs a command answers no signal before it ends
status=0
wait $lines_pid || status=$?
[ $status = 0 ] || { cat slurm-*.out 2> /dev/null || true; fail "README's lines ended with status $status"; }
echo "$(ls part-*.png | wc -l) parts drawn and joined in $((($(date +%s%N) - begun) / 1000000)) ms"

java -jar build/libs/RayTracer.jar scenes/boxes.txt expected.png 900 900 --quiet
different=$(compare -metric AE whole.png expected.png null: 2>&1) || true
echo "pixels that differ from the picture in one piece: $different"
[ "$different" = 0 ] || fail "the parts are not the whole; both are in $folder/checkout"
