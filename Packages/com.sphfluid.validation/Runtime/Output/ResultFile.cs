using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A file that a measurement writes.</summary>
    internal readonly struct ResultFile
    {
        private ResultFile(string name, string firstLine, string script)
        {
            Name = name;
            FirstLine = firstLine;
            Script = script;
        }

        /// <summary>Below the folder of the results, for instance "curves/ellipsoid.thesis.csv".</summary>
        public string Name { get; }

        /// <summary>The first line of every version of the file; null for a picture.</summary>
        public string FirstLine { get; }

        /// <summary>The script that draws the picture, a file of the same measurement; null where there is none.</summary>
        public string Script { get; }

        /// <summary>A table.</summary>
        public static ResultFile Table(string name, IEnumerable<string> columns) => Text(name, CsvText.Join(columns));

        /// <summary>A text that always begins with the same line.</summary>
        public static ResultFile Text(string name, string firstLine) => new ResultFile(name, firstLine, null);

        /// <summary>A picture that a script draws.</summary>
        public static ResultFile Drawn(string name, string script) => new ResultFile(name, null, script);

        /// <summary>A picture.</summary>
        public static ResultFile Picture(string name) => new ResultFile(name, null, null);
    }
}
