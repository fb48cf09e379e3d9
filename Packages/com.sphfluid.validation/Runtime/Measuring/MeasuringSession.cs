using System.Collections;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A measurement that writes its results to a folder.</summary>
    public abstract class MeasuringSession : IValidationSession
    {
        private readonly SessionWork work;
        private ResultFolder results;
        private bool disposed;

        /// <param name="arguments">What to measure.</param>
        /// <param name="progress">Where it says how far it is.</param>
        private protected MeasuringSession(MeasuringArguments arguments, SessionProgress progress)
        {
            Folder = arguments.OutputFolder;
            Progress = progress;
            work = new SessionWork(Run());
        }

        /// <summary>Folder of the results.</summary>
        private protected string Folder { get; }

        private protected SessionProgress Progress { get; }

        /// <inheritdoc/>
        public virtual bool Step() => work.Step();

        /// <summary>Frees the GPU memory, and says what is there when it is not done; the files are whole at any time.</summary>
        public void Dispose()
        {
            if (disposed) return;
            disposed = true;
            if (!work.IsDone) Progress.Say("Stopped early. " + Unfinished);
            work.Clear();
            results?.Close();
        }

        /// <summary>Claims the files that the session may write; called by its constructor when it has read what is there.</summary>
        /// <exception cref="CommandLineException">The folder cannot be written, or holds other files of these names.</exception>
        private protected virtual void Claim(IEnumerable<ResultFile> files) => results = ResultFolder.Open(Folder, files);

        /// <summary>The whole work; what it holds in using blocks is freed at the latest with the session.</summary>
        private protected abstract IEnumerator Run();

        /// <summary>What the folder holds of a session that was stopped.</summary>
        private protected abstract string Unfinished { get; }
    }
}
