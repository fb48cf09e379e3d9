# Written by ./run help --update from the flags that the parsers read; run reads it.
verbs='play bench chart choose stability leaks surfaces merge budgets figures check model mutate docs devices publish build help'
declare -A all_flags=(
    [play]='--scene --seconds --fps --size --out --device --no-images --open --validate --method --budget --surface --particles --seed --state --mesh --record'
    [bench]='--device --validate --table --particles --grids --repeat --out --sweep --no-sweep --scene --phases --against --fps --size --method --surface --seed'
    [chart]='--device --validate --quick --case --method --out --slice --shard'
    [choose]='--device --validate --case --error --ms --fps --length --speed --volume --compression --chart --verify --out'
    [stability]='--device --validate --quick --map --method --out --slice --shard'
    [leaks]='--device --validate --scene --out --shard'
    [surfaces]='--device --validate --quick --state --variant --out --shard'
    [merge]='--device --validate --errors-only --out'
    [budgets]='--device --validate --budget --particles --repeat --out'
    [figures]='--only --out'
    [check]='--only --update'
    [model]='--state --radius'
    [mutate]='--shaders --scripts --seed --files --only --map --map-filter --again --survivors --seconds --list --work --out'
)
declare -A player_values=(
    [play]='--scene --seconds --fps --size --out --device'
    [bench]='--device'
    [chart]='--device'
    [choose]='--device'
    [stability]='--device'
    [leaks]='--device'
    [surfaces]='--device'
    [merge]='--device'
    [budgets]='--device'
)
declare -A player_switches=(
    [play]='--no-images --open --validate'
    [bench]='--validate'
    [chart]='--validate'
    [choose]='--validate'
    [stability]='--validate'
    [leaks]='--validate'
    [surfaces]='--validate'
    [merge]='--validate'
    [budgets]='--validate'
)
