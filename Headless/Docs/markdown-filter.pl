# Headings of a page get the anchors that its readers elsewhere link to, and links their form in Doxygen:
# "## Open a face" of domain.md becomes "## Open a face {#domain-open-a-face}", [faces](domain.md#open-a-face) a reference to it. The front
# page ends with the table of contents, whose order is that of the side bar.
use strict;
use warnings;
use File::Basename;

my %languages = (csharp => '.cs', hlsl => '.c', json => '.js');
my $file = $ARGV[0];
my $page = basename($file, q(.md));

# As GitHub names them: "Force Times Mass (6.3.3)" is force-times-mass-633.
sub label {
    my ($heading) = @_;
    $heading = lc $heading;
    $heading =~ s/[^\w\- ]//g;
    $heading =~ s/ /-/g;
    return "$page-$heading";
}

sub target {
    my ($link) = @_;
    return "\@ref $page-$1" if $link =~ /^#(.+)$/;
    $link =~ s{^\.\./\.\./com\.sphfluid[\w.]*/Documentation~/}{}; # another package's page
    return "\@ref page-$1" if $link =~ /^([\w-]+)\.md$/;
    return "\@ref $1-$2" if $link =~ /^([\w-]+)\.md#(.+)$/;
    return $link;
}

# "* [Domain](domain.md)" makes Domain a page below this one.
sub contents {
    my ($file) = @_;
    open my $in, '<', $file or die "$file: $!";
    local $/ = "\n";
    my @lines = grep { !/\(index\.md\)/ } <$in>;
    s{\[([^\]]+)\]\(([\w-]+)\.md\)}{\@subpage page-$2} for @lines;
    return "\n## Contents {#contents}\n\n" . join('', @lines) . "* [Playback](\@ref page-playback)\n* [Beyond one machine](\@ref page-beyond-one-machine)\n";
}

sub prose {
    my ($text) = @_;
    $text =~ s/<!--(?:fact:[^\s>]+|\/)-->//g;
    $text =~ s/^<!-- (?:given|not compiled):.*?-->\n//gms;
    $text =~ s/^# (.+?)[ \t]*$/$page eq 'index' ? "# $1" : "# $1 {#page-$page}"/gme;
    $text =~ s/^(#{2,6}) (.+?)[ \t]*$/"$1 $2 {#" . label($2) . "}"/gme;
    $text =~ s{(?<!\!)\[([^\[\]]+)\]\(\.\./Samples~[^()\s]*\)}{$1}g; # no pages here
    # Doxygen does not find the end of a link whose words go over the end of a line.
    $text =~ s/(?<=\[)([^\[\]\n]*)\n([^\[\]\n]*\]\()/$1 $2/g;
    $text =~ s{(?<!\!)\[([^\[\]]*)\]\(([^()\s]+)\)}{"[$1](" . target($2) . ")"}ge;
    return $text;
}

local $/;
my $text = <>;
my @parts = split /^( *```[^\n]*\n.*?^ *```[ \t]*\n)/ms, $text;
for my $i (0 .. $#parts) {
    if ($i % 2) { $parts[$i] =~ s/^( *```)(csharp|hlsl|json)\s*\n/"$1\{$languages{$2}}\n"/e; }
    else { $parts[$i] = prose($parts[$i]); }
}
print @parts;
print contents($file =~ s/index\.md$/TableOfContents.md/r) if $page eq 'index';
