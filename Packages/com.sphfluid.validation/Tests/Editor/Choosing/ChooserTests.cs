using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Answers of a chart whose laws are known.</summary>
    public sealed class ChooserTests
    {
        private MadeUpChart chart;
        private Chooser chooser;

        [SetUp]
        public void SetUp()
        {
            chart = new MadeUpChart();
            foreach (string method in new[] { "standard", "thesis" })
            {
                chart.Sweep(method, 2.0, 5.0, 6, 8, 12, 18);
                chart.Sweep(method, 2.5, 5.0, 6, 8, 12, 18);
            }
            chooser = new Chooser(chart.Data(), new[] { chart.Case });
        }

        [Test]
        public void ErrorAndTimeOfAnOptionFollowTheLaws()
        {
            ChoiceAnswer answer = Ask(0.5, double.NaN);

            foreach (ChoiceOption option in answer.Options)
            {
                int count = option.Resolution * option.Resolution * option.Resolution;
                // dt = 0.5 dx/c, c = 5: 10 n steps a second.
                double frame = MadeUpChart.StepTimeOf(option.Method, option.SupportRatio, count) * 10.0 * option.Resolution / 60.0;
                double error = Math.Max(0.04, MadeUpChart.ErrorOf(option.Method, option.SupportRatio, option.Resolution));
                Assert.That(option.Particles, Is.EqualTo(count).Within(0.02 * count), $"{option}");
                Assert.That(option.Milliseconds.Value, Is.EqualTo(frame).Within(0.06 * frame), $"{option}");
                Assert.That(option.Error.Value, Is.EqualTo(error).Within(0.01 * error), $"{option}");
                Assert.That(option.Milliseconds.Contains(frame), Is.True);
            }
            Assert.That(answer.Options.Select(o => o.Resolution).Distinct(), Is.EquivalentTo(Enumerable.Range(6, 13)));
        }

        [Test]
        public void TheFastestWithTheErrorIsChosen()
        {
            ChoiceAnswer answer = Ask(0.2, double.NaN);
            ChoiceOption expected = answer.Options.Where(o => Math.Sqrt(o.Error.Value * o.Error.High) <= 0.2)
                .OrderBy(o => o.Milliseconds.Likely).First();

            Assert.That(answer.Best, Is.SameAs(expected));
            // 20/n² of κ = 2.5: eleven along the length; 3/n of κ = 2 needs sixteen.
            Assert.That((answer.Best.Method, answer.Best.SupportRatio), Is.EqualTo(("standard", 2.5)));
            Assert.That(answer.Best.Resolution, Is.InRange(10, 13));
            Assert.That(answer.PerMethod.Select(o => o.Method), Is.EquivalentTo(new[] { "standard", "thesis" }));
        }

        [Test]
        public void TheMostAccurateWithinTheTimeIsChosen()
        {
            ChoiceOption best = Ask(double.NaN, 6.0).Best;

            Assert.That(best.Milliseconds.Likely, Is.LessThanOrEqualTo(6.0));
            Assert.That(Ask(double.NaN, 6.0).Options.Where(o => o.Milliseconds.Likely <= 6.0).Min(o => o.Error.Likely),
                Is.EqualTo(best.Error.Likely));
        }

        [Test]
        public void AskingForMoreCostsMore()
        {
            double last = double.PositiveInfinity;
            for (double error = 0.05; error < 0.6; error *= 1.1)
            {
                ChoiceOption best = Ask(error, double.NaN).Best;
                double time = best?.Milliseconds.Likely ?? double.PositiveInfinity;
                Assert.That(time, Is.LessThanOrEqualTo(last), $"{error}");
                last = time;
            }
            last = double.PositiveInfinity;
            for (double time = 0.5; time < 100.0; time *= 1.2)
            {
                double error = Ask(double.NaN, time).Best?.Error.Likely ?? double.PositiveInfinity;
                Assert.That(error, Is.LessThanOrEqualTo(last), $"{time} ms");
                last = error;
            }
        }

        [Test]
        public void AnAnswerHoldsWhatIsAlsoHeldThoughAnotherIsFaster()
        {
            // Standard drifts by twice its error, the thesis by half of it.
            chart = new MadeUpChart { DriftOver = method => method == "standard" ? 2.0 : 0.5 };
            foreach (string method in new[] { "standard", "thesis" }) chart.Sweep(method, 2.5, 5.0, 6, 8, 12, 18);
            chooser = new Chooser(chart.Data(), new[] { chart.Case });
            ChoiceOption fastest = Ask(0.3, double.NaN).Best;
            chart.Case.Held = new[] { ("drift", 0.0) };
            chooser = new Chooser(chart.Data(), new[] { chart.Case });
            ChoiceAnswer answer = Ask(0.3, double.NaN);

            Assert.That(fastest.Method, Is.EqualTo("standard"));
            Assert.That(answer.Holds(answer.Best), Is.True);
            Assert.That(answer.Best.Beside.Single(), Is.LessThanOrEqualTo(0.3));
            Assert.That(answer.Best.Milliseconds.Likely, Is.GreaterThan(fastest.Milliseconds.Likely));
            Assert.That(string.Join("\n", ChoiceText.Lines(answer)), Does.Contain("Beside it").And.Contain("drift off by"));
            Assert.That(string.Join("\n", new ChoiceScript(answer).Lines()), Does.Contain("beyond in another error"));
        }

        [Test]
        public void WhatNothingHoldsIsNamed()
        {
            chart = new MadeUpChart { DriftOver = _ => 50.0 };
            chart.Case.Held = new[] { ("drift", 0.0), ("swirl", 1.0) };
            chart.Sweep("standard", 2.5, 5.0, 6, 8, 12, 18);
            chooser = new Chooser(chart.Data(), new[] { chart.Case });
            ChoiceAnswer answer = Ask(0.3, double.NaN);

            Assert.That(answer.Best, Is.Not.Null, "the main error is kept");
            Assert.That(string.Join("\n", ChoiceText.Lines(answer)), Does.Contain("Nothing that was measured holds all of it").And
                .Contain("swirl not measured"));
            string line = ChoiceRow.Format.Line(ChoiceRow.Of(answer).First());
            Assert.That(CsvText.Split(line)[ChoiceRow.Format.Names.ToList().IndexOf("holds_beside")], Is.EqualTo("0"));
            Assert.That(line, Does.Contain("drift: ").And.Contain("swirl: "));
        }

        // At 10, between 8 and 12, the worse of the two; at 12 its own, in its worst seed.
        [Test]
        public void WhatIsAlsoHeldIsThatOfTheWorseSpacingBesideIt()
        {
            chart.Case.Held = new[] { ("drift", 0.0) };
            chooser = new Chooser(chart.Data(), new[] { chart.Case });
            ChoiceAnswer answer = Ask(0.5, double.NaN);
            double Drift(int resolution) => answer.Options.Single(o => o.Method == "standard" && o.SupportRatio == 2.5 &&
                o.Resolution == resolution).Beside.Single();
            double Worst(int resolution) => 0.1 * 1.02 * MadeUpChart.ErrorOf("standard", 2.5, resolution);

            Assert.That(Drift(10), Is.EqualTo(Worst(8)).Within(1e-6));
            Assert.That(Drift(12), Is.EqualTo(Worst(12)).Within(1e-6));
        }

        [Test]
        public void AWideIntervalNamesTheRunsThatNarrowIt()
        {
            chart = new MadeUpChart();
            double[] zigzag = { 1.0, 0.1, 1.0 };
            int[] resolutions = { 6, 10, 16 };
            for (int i = 0; i < resolutions.Length; i++)
            {
                for (int seed = 1; seed <= 3; seed++) chart.Add("standard", 2.5, 5.0, resolutions[i], seed, null, zigzag[i]);
            }
            chooser = new Chooser(chart.Data(), new[] { chart.Case });
            ChoiceOption option = Ask(0.5, double.NaN).Options.Single(o => o.Resolution == 13);
            IReadOnlyList<ChartRun> runs = ChoiceNarrowing.Runs(option, chart.Case);

            Assert.That(ChoiceNarrowing.Width(option, chart.Case), Is.GreaterThan(ChoiceNarrowing.Widest));
            Assert.That(runs.Select(r => r.Seed), Is.EqualTo(new[] { 1, 2, 3 }));
            Assert.That(runs[0].Config.Parameters(1).Resolution, Is.EqualTo(13));
            foreach (ChartRun run in runs) chart.Add("standard", 2.5, 5.0, 13, run.Seed);
            chooser = new Chooser(chart.Data(), new[] { chart.Case });
            ChoiceOption after = Ask(0.5, double.NaN).Options.Single(o => o.Resolution == 13);
            Assert.That(ChoiceNarrowing.Width(after, chart.Case), Is.LessThan(ChoiceNarrowing.Width(option, chart.Case)));
        }

        [Test]
        public void ANarrowIntervalNeedsNoRun()
        {
            ChoiceOption best = Ask(0.2, double.NaN).Best;

            Assert.That(ChoiceNarrowing.IsWide(best, chart.Case), Is.False);
            Assert.That(ChoiceNarrowing.Runs(best, chart.Case), Is.Empty);
            Assert.That(string.Join("\n", ChoiceText.Lines(Ask(0.2, double.NaN))), Does.Not.Contain("--narrow"));
        }

        [Test]
        public void AnErrorAtTheFloorIsSaidToBeTheReferences()
        {
            chart.Sweep("standard", 2.5, 5.0, 24);
            chooser = new Chooser(chart.Data(), new[] { chart.Case });

            Assert.That(string.Join("\n", ChoiceText.Lines(Ask(0.04, double.NaN))),
                Does.Contain("4 % is not the liquid's error but what the reference is good for: two made-up rests lie so far apart."));
            Assert.That(string.Join("\n", ChoiceText.Lines(Ask(0.3, double.NaN))), Does.Not.Contain("not the liquid's error"));
        }

        [Test]
        public void WhatCannotBeHasItsNearestInBothDirections()
        {
            ChoiceAnswer answer = Ask(0.1, 2.0);
            string text = string.Join("\n", ChoiceText.Lines(answer));

            Assert.That(answer.Best, Is.Null);
            Assert.That(answer.Fastest.Error.Likely, Is.LessThanOrEqualTo(0.1));
            Assert.That(answer.Fastest.Milliseconds.Likely, Is.GreaterThan(2.0));
            Assert.That(answer.MostAccurate.Milliseconds.Likely, Is.LessThanOrEqualTo(2.0));
            Assert.That(answer.MostAccurate.Error.Likely, Is.GreaterThan(0.1));
            Assert.That(text,
                Does.Contain("keeps an error of at most 10 % and at most 2 ms a frame at once").And.Contain("with that error: ").And
                    .Contain("within that time: "));
        }

        [Test]
        public void WhatWasNotMeasuredIsSaid()
        {
            ChoiceAnswer answer = Ask(double.NaN, 0.001);

            Assert.That(answer.Best, Is.Null);
            Assert.That(string.Join("\n", ChoiceText.Lines(answer)),
                Does.Contain("the least time that was measured").And.Contain("a coarser spacing was not measured"));
        }

        [Test]
        public void ALiquidFourTimesAsLongHasItsOwnSpacingAndVolume()
        {
            ChoiceQuestion question = Question(0.2, double.NaN);
            (question.Length, question.Volume) = (4.0, 16.0);
            ChoiceOption own = Ask(0.2, double.NaN).Options[0], scaled = chooser.Answer(question).Options[0];

            Assert.That(scaled.Spacing, Is.EqualTo(4.0 * own.Spacing).Within(1e-6));
            // A quarter of 4³.
            Assert.That(scaled.Particles, Is.EqualTo(0.25 * own.Particles).Within(0.01 * own.Particles));
            // No gravity, the same speed: four times the time.
            Assert.That(scaled.StepsPerFrame, Is.EqualTo(0.25 * own.StepsPerFrame).Within(1e-6));
            Assert.That(scaled.Error.Value, Is.EqualTo(own.Error.Value));
        }

        [Test]
        public void ALongerFrameHasMoreSteps()
        {
            ChoiceQuestion question = Question(0.2, double.NaN);
            question.FramesPerSecond = 30.0;

            Assert.That(chooser.Answer(question).Options[0].Milliseconds.Value,
                Is.EqualTo(2.0 * Ask(0.2, double.NaN).Options[0].Milliseconds.Value).Within(1e-9));
        }

        [Test]
        public void AnExtrapolatedCostIsSaid()
        {
            ChoiceQuestion question = Question(0.2, double.NaN);
            question.Volume = 1000.0;
            ChoiceAnswer answer = chooser.Answer(question);

            Assert.That(answer.Best.IsBeyondMeasured, Is.True);
            Assert.That(string.Join("\n", ChoiceText.Lines(answer)), Does.Contain("an extrapolation"));
            Assert.That(Ask(0.2, double.NaN).Best.IsBeyondMeasured, Is.False);
        }

        [Test]
        public void SoftLiquidIsChosenOnlyWhereItIsAllowed()
        {
            chart.Sweep("standard", 2.5, 2.5, 6, 8, 12);
            chooser = new Chooser(chart.Data(), new[] { chart.Case });
            ChoiceQuestion soft = Question(0.2, double.NaN);
            soft.Compression = 0.2;

            Assert.That(Ask(0.2, double.NaN).Best.SoundSpeedRatio, Is.EqualTo(5.0));
            Assert.That(chooser.Answer(soft).Best.SoundSpeedRatio, Is.EqualTo(2.5));
        }

        [Test]
        public void StifferThanMeasuredIsRefused()
        {
            ChoiceQuestion stiff = Question(0.2, double.NaN);
            stiff.Compression = 0.001;

            Assert.That(() => chooser.Answer(stiff),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("--compression").And.Message.Contains("4 %"));
        }

        [Test]
        public void NearAFailedRunNothingIsOffered()
        {
            chart.Add("standard", 2.5, 5.0, 15, 1, "it flew apart");
            chooser = new Chooser(chart.Data(), new[] { chart.Case });

            Assert.That(Ask(0.2, double.NaN).Options.Where(o => o.Method == "standard" && o.SupportRatio == 2.5).Select(o => o.Resolution),
                Is.EquivalentTo(Enumerable.Range(6, 7).Append(18)));
        }

        [Test]
        public void TheTextAsPrintedIsNeverChosen()
        {
            chart.Sweep("thesis-printed", 2.0, 5.0, 6, 12);
            chooser = new Chooser(chart.Data(), new[] { chart.Case });

            Assert.That(Ask(0.5, double.NaN).Options.Any(o => o.Method == "thesis-printed"), Is.False);
        }

        [Test]
        public void QuestionsWithoutAnAnswerAreRefused()
        {
            Assert.That(() => Ask(double.NaN, double.NaN),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("--error").And.Message.Contains("--ms"));
            Assert.That(() => Ask(0.03, double.NaN),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("good for 4 % (two made-up rests"));
            Assert.That(() => chooser.Answer(new ChoiceQuestion { Case = new FlatCase("another"), Error = 0.1 }),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("./run chart --case another"));
        }

        [Test]
        public void QuestionsThatAreVerifiedHaveAnswers()
        {
            var questions = ChoiceVerification.Questions(chooser, new ChoiceQuestion(), 10).ToList();

            Assert.That(questions, Has.Count.EqualTo(10));
            Assert.That(questions.Count(q => double.IsNaN(q.Error)), Is.InRange(3, 7));
            Assert.That(questions.All(q => chooser.Answer(q).Best != null), Is.True);
            Assert.That(questions.Select(q => (q.Error, q.Milliseconds)).Distinct().Count(), Is.GreaterThan(5));
        }

        [Test]
        public void TheFitsHaveTheOrdersOfTheLaws()
        {
            ErrorFitRow[] fits = ErrorFitRow.Of(chart.Data(), new[] { chart.Case }).ToArray();

            Assert.That(fits, Has.Length.EqualTo(4));
            // κ = 2 is of first order, 2.5 of second.
            Assert.That(fits.Select(f => Math.Round(f.Order, 3)), Is.EquivalentTo(new[] { 1.0, 2.0, 1.0, 2.0 }));
            Assert.That(fits.All(f => f.OrderError < 1e-6), Is.True);
            Assert.That(StepFitRow.Of(chart.Data()).Select(r => StepFitRow.Format.Line(r)), Has.Exactly(2).Items);
        }

        [Test]
        public void AQuestionOfOneTimeMeasuresPaceAgainstTheChart()
        {
            var row = new VerificationRow(Question(0.2, double.NaN), Ask(0.2, double.NaN).Best) { Pace = 2.0 };
            row.MeasuredMilliseconds = 1.5 * row.Answer.Milliseconds.Value;
            row.MeasuredError = row.Answer.Error.Value;
            string[] cells = VerificationRow.Format.Line(row).Split(',');

            Assert.That((row.TimeWithin, VerificationRow.IsNear(row.TimeRatio / row.Pace), row.ErrorWithin),
                Is.EqualTo((false, true, true)));
            Assert.That(cells[VerificationRow.Format.Names.ToList().IndexOf("paced_ratio")], Is.EqualTo("0.75"));
        }

        [Test]
        public void ThePictureHasWhatWasAskedAndTheAnswer()
        {
            string asked = string.Join("\n", new ChoiceScript(Ask(0.2, 50.0)).Lines()),
                nothing = string.Join("\n", new ChoiceScript(Ask(0.1, 2.0)).Lines());

            Assert.That(asked,
                Does.Contain("$answer << END").And.Contain("first 0.2 to graph 1").And.Contain("from 50, graph 0").And
                    .Contain("the answer, and where 19 of 20"));
            Assert.That(nothing,
                Does.Contain("the nearest in both directions").And.Contain("nothing that was measured has what was asked for"));
        }

        private ChoiceAnswer Ask(double error, double milliseconds) => chooser.Answer(Question(error, milliseconds));

        private ChoiceQuestion Question(double error, double milliseconds) =>
            new ChoiceQuestion { Case = chart.Case, Error = error, Milliseconds = milliseconds };
    }
}
