using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// manifest.json: what was exported from what, all that the scripts know of it, and a hash of every file. Names are those of the file's
    /// keys; no inspector shows them.
    /// </summary>
    [Serializable]
    internal sealed class ExportManifest
    {
        public const string FormatName = "sphfluid-export";

        [HideInInspector] public string format; // set when it is written, so that a file without it is none of ours
        [HideInInspector] public int version = 2;
        [HideInInspector] public string package = "com.sphfluid";
        [HideInInspector] public string packageVersion = FluidPackage.Version;
        [HideInInspector] public string commit = "";
        [HideInInspector] public string scene = "";
        [HideInInspector] public string simulation = "";
        [HideInInspector] public string engine = "PySPH";
        [HideInInspector] public string engineVersion = PysphCase.EngineVersion;
        [HideInInspector] public string scheme = "";
        [HideInInspector] public double seconds;
        [HideInInspector] public double frameRate;
        [HideInInspector] public double spacing;
        [HideInInspector] public double density;
        [HideInInspector] public double viscosity; // kinematic [m²/s]
        [HideInInspector] public double soundSpeed;
        [HideInInspector] public double[] gravity = Array.Empty<double>();
        [HideInInspector] public double[] domainSize = Array.Empty<double>();
        [HideInInspector] public double[] position = Array.Empty<double>(); // of the box in the world [m]
        [HideInInspector] public double[] rotation = Array.Empty<double>(); // a quaternion: x, y, z, w
        [HideInInspector] public List<string> openFaces = new List<string>();
        [HideInInspector] public List<string> periodicAxes = new List<string>();
        [HideInInspector] public long liquidParticles;
        [HideInInspector] public long wallParticles;
        [HideInInspector] public List<Body> bodies = new List<Body>();
        [HideInInspector] public List<Reading> readings = new List<Reading>();
        [HideInInspector] public List<Entry> files = new List<Entry>();
        [HideInInspector] public List<Note> notExported = new List<Note>();

        /// <summary>A collider that moves.</summary>
        [Serializable]
        internal sealed class Body
        {
            [HideInInspector] public string name;
            [HideInInspector] public long particles;
            [HideInInspector] public int poses;
        }

        /// <summary>A quantity that a probe reads, or the height at a gauge; simulation space.</summary>
        [Serializable]
        internal sealed class Reading
        {
            [HideInInspector] public string name;
            [HideInInspector] public string property;
            [HideInInspector] public double[] place;
            [HideInInspector] public double[] up;
            [HideInInspector] public double length;
        }

        /// <summary>A file of the case.</summary>
        [Serializable]
        internal sealed class Entry
        {
            [HideInInspector] public string name;
            [HideInInspector] public long bytes;
            [HideInInspector] public string sha256;
        }

        /// <summary>What the engine cannot express.</summary>
        [Serializable]
        internal sealed class Note
        {
            [HideInInspector] public string name;
            [HideInInspector] public string text;
            [HideInInspector] public string cure;
        }
    }
}
