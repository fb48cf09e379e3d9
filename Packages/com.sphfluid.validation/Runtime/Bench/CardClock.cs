using System;
using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// The clock of a graphics card, where its driver tells it outside the graphics API: NVIDIA's by nvidia-smi, AMD's on Linux.
    /// </summary>
    public static class CardClock
    {
        private const string NvidiaQuery = "--query-gpu=name,clocks.sm --format=csv,noheader,nounits";
        private const string LinuxCards = "/sys/class/drm";
        private const int NvidiaVendor = 0x10de;
        private const int LongestWait = 5000; // ms

        /// <summary>The clock of the device in use now [MHz]; not a number where nothing tells it.</summary>
        public static double Megahertz()
        {
            try
            {
                return SystemInfo.graphicsDeviceVendorID == NvidiaVendor ? OfNvidia(AskNvidia(), SystemInfo.graphicsDeviceName)
                    : OfLinux(LinuxCards, SystemInfo.graphicsDeviceVendorID, SystemInfo.graphicsDeviceID);
            }
            catch (Exception exception) when (exception is Win32Exception || exception is IOException ||
                exception is UnauthorizedAccessException)
            {
                return double.NaN; // no such program or file
            }
        }

        /// <summary>The clock of a card in what nvidia-smi says, e.g. 1980 of the line "NVIDIA H200, 1980" [MHz].</summary>
        /// <param name="answer">A line a card: its name, a comma and its clock.</param>
        /// <param name="card">Name of the card; not a number where no line has it.</param>
        public static double OfNvidia(string answer, string card)
        {
            foreach (string line in answer.Split('\n'))
            {
                int comma = line.LastIndexOf(',');
                if (comma > 0 && line.Substring(0, comma).Trim() == card) return Number(line.Substring(comma + 1));
            }
            return double.NaN;
        }

        /// <summary>The clock of a card in the files of amdgpu, e.g. 2475 of the line "1: 2475Mhz *" [MHz].</summary>
        /// <param name="folder">A folder a card, in each a folder device.</param>
        /// <param name="vendor">Number of the card's vendor.</param>
        /// <param name="device">Number of the card; not a number where no folder has both.</param>
        public static double OfLinux(string folder, int vendor, int device)
        {
            if (!Directory.Exists(folder)) return double.NaN;
            foreach (string card in Directory.GetDirectories(folder).Select(d => Path.Combine(d, "device")))
            {
                string clocks = Path.Combine(card, "pp_dpm_sclk");
                if (!File.Exists(clocks) || Hexadecimal(Path.Combine(card, "vendor")) != vendor ||
                    Hexadecimal(Path.Combine(card, "device")) != device)
                {
                    continue;
                }
                string now = File.ReadAllLines(clocks).FirstOrDefault(line => line.TrimEnd().EndsWith("*"));
                if (now != null) return Number(new string(now.Substring(now.IndexOf(':') + 1).Trim().TakeWhile(char.IsDigit).ToArray()));
            }
            return double.NaN;
        }

        private static string AskNvidia()
        {
            var start = new ProcessStartInfo("nvidia-smi", NvidiaQuery) { RedirectStandardOutput = true, UseShellExecute = false };
            using (Process process = Process.Start(start))
            {
                if (!process.WaitForExit(LongestWait)) return "";
                return process.StandardOutput.ReadToEnd();
            }
        }

        private static double Number(string text) =>
            double.TryParse(text.Trim(), NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : double.NaN;

        private static int Hexadecimal(string file)
        {
            string text = File.Exists(file) ? File.ReadAllText(file).Trim() : "";
            return text.StartsWith("0x") && int.TryParse(text.Substring(2), NumberStyles.HexNumber, CultureInfo.InvariantCulture,
                out int number) ? number : 0;
        }
    }
}
