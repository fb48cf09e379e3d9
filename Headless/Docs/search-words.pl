# Doxygen's search knows names of types and members, and titles of pages. This gives it the words of the manual as well: each leads to the sections that have it, those first
# whose heading has it.
#   perl Headless/Docs/search-words.pl Build/docs
use strict;
use warnings;

my ($folder) = @ARGV;
my %common = map { $_ => 1 } qw(an and are as at be but by can do for from go has have how if in into is it its no not of on one or out so that the then there they this those through to up was we were what when where which while who with
    without you your);
my (%sections, %entries); # word: its sections, best first; letter: lines of the index

sub words { return map { lc } shift =~ /\b[A-Za-z]{2,}\b/g; }

sub quoted { return shift =~ s/(['\\])/\\$1/gr; }

for my $page (glob "$folder/page-*.html $folder/index.html") {
    open my $in, '<', $page or die "$page: $!";
    my $html = do { local $/; <$in> };
    my ($title) = $html =~ m{<div class="title">(.*?)</div>}s or next;
    my ($body) = $html =~ m{<div class="textblock">(.*)</div></div><!-- contents -->}s or next;
    $title =~ s/\s+$//;
    my $name = $page =~ s{.*/}{}r;
    my @parts = split m{<h[1-6]><a class="anchor" id="([^"]+)"></a>\s*(.*?)</h[1-6]>}s, $body;
    unshift @parts, '', $title;
    while (my ($anchor, $heading, $text) = splice @parts, 0, 3) {
        $_ = s/<[^>]*>/ /gr =~ s/&#?\w+;/ /gr for $heading, $text;
        my $place = join '', "['../$name", ($anchor ? "#$anchor" : ''), "',1,'", quoted($anchor ? "$title: $heading" : $title), "']";
        my %heads = map { $_ => 1 } words("$heading $title");
        my %seen;
        for my $word (grep { (length > 2 || $heads{$_}) && !$common{$_} && !$seen{$_}++ } words("$heading $text")) { push @{$sections{$word}[$heads{$word} ? 0 : 1]}, $place; }
    }
}

for my $file (glob "$folder/search/all_*.js") {
    open my $in, '<', $file or die "$file: $!";
    while (<$in>) { push @{$entries{lc $1}}, $_ =~ s/,?\s*$//r if /^\s*\['(.)/; }
}
for my $word (keys %sections) {
    my @places = map { @{$_ // []} } @{$sections{$word}}[0, 1];
    push @{$entries{substr $word, 0, 1}}, "  ['${word}_0',['$word'," . join(',', @places) . ']]';
}

my @letters = sort keys %entries;
open my $page, '<', glob "$folder/search/all_0.html" or die $!;
my $html = do { local $/; <$page> };
for my $i (0 .. $#letters) {
    my $number = sprintf '%x', $i;
    open my $out, '>', "$folder/search/all_$number.js" or die $!;
    print $out "var searchData=\n[\n", join(",\n", sort @{$entries{$letters[$i]}}), "\n];\n";
    open $out, '>', "$folder/search/all_$number.html" or die $!;
    print $out $html =~ s/all_0\.js/all_$number.js/r;
}

my $index = "$folder/search/searchdata.js";
open my $in, '<', $index or die $!;
my $data = do { local $/; <$in> };
$data =~ s/^  0: "[^"]*"/'  0: "' . join('', @letters) . '"'/me;
open my $out, '>', $index or die $!;
print $out $data;
print scalar(keys %sections), " words of the manual in the search\n";
