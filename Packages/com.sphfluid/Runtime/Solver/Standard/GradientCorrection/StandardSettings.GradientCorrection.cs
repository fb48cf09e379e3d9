namespace SphFluid
{
    // What the gradient correction adds.
    public partial struct StandardSettings
    {
        /// <summary>
        /// True: the pressure's gradient is corrected for the arrangement of the neighbours (kernel gradient correction, Bonet and Lok
        /// 1999, in its conservative form), and the density's noise is evened out by diffusion (Antuono et al. 2012), so that waves last.
        /// False: neither.
        /// </summary>
        public bool GradientCorrection;
    }
}
