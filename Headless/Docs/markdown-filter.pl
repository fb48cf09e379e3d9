# Headings of a page get the anchors that its readers elsewhere link to, and links their form in Doxygen:
# "## Open a face" of domain.md becomes "## Open a face {#domain-open-a-face}", [faces](domain.md#open-a-face) a reference to it.
use strict;
use warnings;
use File::Basename;

my $file = $ARGV[0];
my $page = basename($file, '.md');
my $folder = dirname($file);
my $fenced = 0;

sub label {
    my ($page, $heading) = @_;
    $heading = lc $heading;
    $heading =~ s/[^\w\- ]//g;
    $heading =~ s/ /-/g;
    return "$page-$heading";
}

sub target {
    my ($link) = @_;
    return $link if $link =~ m{://};
    return "\@ref $page-$1" if $link =~ /^#(.+)$/;
    return "\@ref page-$1" . (defined $2 ? "" : "") if $link =~ /^([\w-]+)\.md$/;
    return "\@ref $1-$2" if $link =~ /^([\w-]+)\.md#(.+)$/;
    return $link;
}

while (<>) {
    if (/^ *```/) {
        $fenced = !$fenced;
        s/^( *```)(csharp|hlsl|json)\s*$/"$1\{" . ($2 eq "csharp" ? ".cs" : $2 eq "hlsl" ? ".c" : ".js") . "}\n"/e;
    }
    elsif (!$fenced) {
        next if /^<!-- (?:given|not compiled):/ .. /-->/;
        if (/^# (.+?)\s*$/) { $_ = $page eq "index" ? "# $1\n" : "# $1 {#page-$page}\n"; }
        elsif (/^(#{2,6}) (.+?)\s*$/) { $_ = "$1 $2 {#" . label($page, $2) . "}\n"; }
        s{(?<!\!)\]\(([^()\s]+)\)}{"](" . target($1) . ")"}ge;
    }
    print;
}
