# Says what C# leaves unsaid and Doxygen takes otherwise: types of a namespace without an access modifier are internal, members of
# a struct without one are private. The layout is that of the packages: four blanks a level, the namespace's types at four.
use strict;
use warnings;

my @kinds;
my $begins = 1;

while (<>) {
    my ($indent, $code) = /^( *)(\S.*)?$/;
    if (defined $code && $code !~ m{^(?://|\#)}) {
        my $level = length($indent) / 4;
        my $kind = $code =~ /^(?:(?:public|internal|private|protected|sealed|static|abstract|readonly|partial|unsafe|ref|new) )*(class|struct|interface|enum) \w/ ? $1 : '';
        if ($begins && $code =~ /^\w/ && $code !~ /^(?:public|internal|private|protected|namespace|using)\b/) {
            if ($level == 1 && $kind) { $_ = "${indent}internal $code\n"; }
            elsif ($level > 1 && ($kinds[$level - 1] // '') eq 'struct') { $_ = "${indent}private $code\n"; }
        }
        $kinds[$level] = $kind if $kind;
        $kinds[$level] = '' if $begins && !$kind;
        $begins = $code =~ m{[;{}\]](?:\s*//.*)?$};
    }
    # Text in braces of an interpolated string looks like code to Doxygen.
    s/\$"(?:[^"\\]|\\.)*"/""/g unless m{^\s*///};
    # A body without braces behind another constructor: "public A(int b) : this(b, 0) => c = b;"
    s/(:\s*(?:base|this)\(.*\)) => (.+);\s*$/$1 { $2; }\n/;
    print;
}
