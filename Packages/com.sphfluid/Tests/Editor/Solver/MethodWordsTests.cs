using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Documentation comments and tooltips that say which methods have a thing name those that do.</summary>
    public sealed class MethodWordsTests
    {
        private const string Runtime = "Packages/com.sphfluid/Runtime";

        private const string Methods = "(?<m>Standard|Robust|Thesis)";

        private static readonly Regex Word =
            new Regex($@"\b{Methods} method|\bmethods? {Methods}(?: and {Methods})?|\bFluidMethodKind\.{Methods}\b",
                RegexOptions.IgnoreCase);

        private static IEnumerable<string> ProfileFields() =>
            typeof(FluidProfile).GetFields(BindingFlags.Instance | BindingFlags.NonPublic)
                .Where(f => f.GetCustomAttribute<TooltipAttribute>() != null).Select(f => f.Name);

        [TestCase("method Standard", "standard")]
        [TestCase("Standard method only; the thesis's text", "standard")]
        [TestCase("(methods Standard and Robust)", "robust standard")]
        [TestCase("<see cref=\"FluidMethodKind.Thesis\"/> only, standard water", "thesis")]
        public void WordsAreRead(string text, string methods) => Assert.That(Named(text), Is.EqualTo(methods.Split(' ')));

        [TestCase("FluidBoundaries", "Open", FluidMethodFeatures.OpenFaces)]
        [TestCase("FluidSimulationSettings", "startRelaxation", FluidMethodFeatures.RelaxedStart)]
        [TestCase("FluidSimulationSettings", "StartRelaxation", FluidMethodFeatures.RelaxedStart)]
        [TestCase("FluidStartRelaxation", "FluidStartRelaxation", FluidMethodFeatures.RelaxedStart)]
        [TestCase("FluidSoundSpeedMode", "FluidSoundSpeedMode", FluidMethodFeatures.FollowingSoundSpeed)]
        [TestCase("FluidProfile", "SoundSpeedMode", FluidMethodFeatures.FollowingSoundSpeed)]
        [TestCase("FluidProfile", "SurfaceTension", FluidMethodFeatures.SurfaceTension)]
        [TestCase("FluidProfile", "TensionAtAnySpacing", FluidMethodFeatures.SurfaceTension)]
        [TestCase("FluidProfile", "ContactAngle", FluidMethodFeatures.SurfaceTension)]
        [TestCase("FluidRuleInput", "SurfaceTension", FluidMethodFeatures.SurfaceTension)]
        [TestCase("FluidVolume", "FluidVolume", FluidMethodFeatures.ChangingCount)]
        public void TheMethodsThatOfferItAreNamed(string file, string member, object feature)
        {
            IEnumerable<string> offer = FluidMethods.All.Where(m => m.Has((FluidMethodFeatures)feature)).Select(NameOf);
            Assert.That(Named(TextBefore(file, member)), Is.EqualTo(Sorted(offer)));
        }

        [TestCaseSource(nameof(ProfileFields))]
        public void AFieldOfAProfileNamesTheMethodsThatReadIt(string field)
        {
            string[] read = Sorted(FluidMethods.All.Where(m => m.ProfileFields.Contains(field)).Select(NameOf));
            string tooltip = typeof(FluidProfile).GetField(field, BindingFlags.Instance | BindingFlags.NonPublic)
                .GetCustomAttribute<TooltipAttribute>().tooltip;
            string comment = TextBefore("FluidProfile", char.ToUpperInvariant(field[0]) + field.Substring(1));
            if (read.Length == 0) Assert.That(tooltip + comment, Does.Not.Contain(" only"), "all methods read it");
            if (read.Length == 1) Assert.That(Named(comment), Is.EqualTo(read), comment);
            if (read.Length > 0) Assert.That(Named(tooltip), Is.Empty.Or.EqualTo(read), tooltip);
        }

        private static string NameOf(FluidMethod method) => method.Kind == FluidMethodKind.ThesisPrinted ? nameof(FluidMethodKind.Thesis)
            : method.Kind.ToString();

        private static string[] Sorted(IEnumerable<string> names) =>
            names.Select(n => n.ToLowerInvariant()).Distinct().OrderBy(n => n).ToArray();

        private static string[] Named(string text) =>
            Sorted(Word.Matches(text).Cast<Match>().SelectMany(m => m.Groups["m"].Captures.Cast<Capture>()).Select(c => c.Value));

        /// <summary>Comments and attributes before a member's declaration.</summary>
        private static string TextBefore(string file, string member)
        {
            string[] lines =
                File.ReadAllLines(Directory.GetFiles(Path.GetFullPath(Runtime), file + ".cs", SearchOption.AllDirectories).Single());
            var declaration = new Regex($@"^\s*(?:[\w<>]+ )+{member}\b(?!\()");
            int at = System.Array.FindIndex(lines, l => declaration.IsMatch(l));
            Assert.That(at, Is.Positive, $"{file} has no {member}");
            int first = at;
            while (lines[first - 1].Trim() is { Length: > 0 } before && before != "{") first--;
            return string.Join(" ", lines.Skip(first).Take(at - first).Select(l => l.Trim().TrimStart('/').Trim()));
        }
    }
}
