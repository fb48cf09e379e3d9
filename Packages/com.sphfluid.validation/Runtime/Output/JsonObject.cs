using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

namespace SphFluid.Validation
{
    /// <summary>A JSON object written key by key; it can be added to the end of an object that is already on disk.</summary>
    public sealed class JsonObject
    {
        private readonly List<string> members = new List<string>();

        /// <summary>Adds a text.</summary>
        public JsonObject Add(string key, string value) => AddRaw(key, value == null ? "null" : Quote(value));

        /// <summary>Adds a whole number.</summary>
        public JsonObject Add(string key, long value) => AddRaw(key, value.ToString(CultureInfo.InvariantCulture));

        /// <summary>Adds a number; one that is not finite becomes null, which JSON can hold.</summary>
        public JsonObject Add(string key, double value) => AddRaw(key, Number(value));

        /// <summary>Adds an array of numbers; those that are not finite become null.</summary>
        public JsonObject Add(string key, IEnumerable<double> values) => AddRaw(key, "[" + string.Join(",", values.Select(Number)) + "]");

        /// <summary>Adds an object.</summary>
        public JsonObject Add(string key, JsonObject value) => AddRaw(key, value.ToString());

        /// <summary>Adds an array of objects.</summary>
        public JsonObject Add(string key, IEnumerable<JsonObject> values) => AddRaw(key, "[" + string.Join(", ", values) + "]");

        /// <summary>Adds all members of another object.</summary>
        public JsonObject Append(JsonObject other)
        {
            members.AddRange(other.members);
            return this;
        }

        /// <summary>The object as text, with a line for each member.</summary>
        public override string ToString() => members.Count == 0 ? "{}" : "{\n  " + string.Join(",\n  ", members) + "\n}";

        /// <summary>Writes the object, or adds its members to the object that the file holds.</summary>
        /// <exception cref="InvalidDataException">The file is there and holds no JSON object.</exception>
        public void AppendTo(string file)
        {
            if (!File.Exists(file))
            {
                CsvText.WriteWhole(file, new[] { ToString() });
                return;
            }
            string text = File.ReadAllText(file).TrimEnd();
            if (!text.StartsWith("{", System.StringComparison.Ordinal) || !text.EndsWith("}", System.StringComparison.Ordinal))
            {
                throw new InvalidDataException($"'{file}' holds no JSON object to add to; delete it and play again.");
            }
            string head = text.Substring(0, text.Length - 1).TrimEnd();
            string separator = head.Length == 1 ? "\n  " : ",\n  ";
            CsvText.WriteWhole(file, new[] { head + separator + string.Join(",\n  ", members) + "\n}" });
        }

        private JsonObject AddRaw(string key, string value)
        {
            members.Add(Quote(key) + ": " + value);
            return this;
        }

        private static string Number(double value) =>
            double.IsNaN(value) || double.IsInfinity(value) ? "null" : value.ToString("R", CultureInfo.InvariantCulture);

        private static string Quote(string text)
        {
            var quoted = new StringBuilder("\"");
            foreach (char c in text)
            {
                if (c == '"' || c == '\\')
                    quoted.Append('\\').Append(c);
                else if (c < ' ')
                    quoted.Append("\\u").Append(((int)c).ToString("x4", CultureInfo.InvariantCulture));
                else
                    quoted.Append(c);
            }
            return quoted.Append('"').ToString();
        }
    }
}
