using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>manifest.json: what was exported from what, with a hash of every file. Names are those of the file's keys.</summary>
    [Serializable]
    internal sealed class ExportManifest
    {
        public const string FormatName = "sphfluid-export";

        public string format; // set when it is written, so that a file without it is none of ours
        public int version = 1;
        public string package = "com.sphfluid";
        public string packageVersion = FluidPackage.Version;
        public string commit = "";
        public string scene = "";
        public string simulation = "";
        public string engine = "PySPH";
        public string engineVersion = PysphCase.EngineVersion;
        public string scheme = "";
        public double seconds;
        public double frameRate;
        public double spacing;
        public double[] domainSize = Array.Empty<double>();
        public double[] position = Array.Empty<double>(); // of the box in the world [m]
        public double[] rotation = Array.Empty<double>(); // a quaternion: x, y, z, w
        public List<string> openFaces = new List<string>();
        public long liquidParticles;
        public long wallParticles;
        public List<Body> bodies = new List<Body>();
        public List<string> instruments = new List<string>();
        public List<Entry> files = new List<Entry>();
        public List<Note> notExported = new List<Note>();

        /// <summary>A collider that moves.</summary>
        [Serializable]
        internal sealed class Body
        {
            public string name;
            public long particles;
            public int poses;
        }

        /// <summary>A file of the case.</summary>
        [Serializable]
        internal sealed class Entry
        {
            public string name;
            public long bytes;
            public string sha256;
        }

        /// <summary>What the engine cannot express.</summary>
        [Serializable]
        internal sealed class Note
        {
            public string name;
            public string text;
            public string cure;
        }
    }
}
