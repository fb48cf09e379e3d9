using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The page of the manual that the question mark in the inspector of a component or asset opens.</summary>
    [AttributeUsage(AttributeTargets.Class, Inherited = false)]
    internal sealed class ManualPageAttribute : HelpURLAttribute
    {
        /// <summary>Names the page.</summary>
        /// <param name="page">Its file's name without the ending.</param>
        /// <param name="heading">Heading on it as a link has it; empty: the whole page.</param>
        /// <param name="package">The package whose page it is.</param>
        public ManualPageAttribute(string page, string heading = "", string package = FluidPackage.Name)
            : base(FluidManual.Address(page, heading, package))
        {
            Package = package;
            Page = page;
            Heading = heading;
        }

        /// <summary>The package whose page it is.</summary>
        public string Package { get; }

        /// <summary>The page's file without the ending.</summary>
        public string Page { get; }

        /// <summary>Heading as a link has it.</summary>
        public string Heading { get; }
    }
}
