using Headless.Shaders.SpirV;

namespace Headless.Shaders;

/// <summary>Makes a shader report the indices that lie outside its buffers, groupshared and local arrays.</summary>
/// <remarks>
/// Each thread keeps its first fault and adds it, when it ends, to the log: three uints a site (threads, last index, its
/// array's length). D3D11 defines such an access to a buffer (it reads 0, writes nothing); Metal and OpenGL ES do not, and an
/// access to groupshared memory is undefined everywhere.
/// </remarks>
public static class BoundsCheck
{
    /// <summary>Name of the resource for the log.</summary>
    public const string LogName = "$Bounds";

    /// <summary>Uints of the log a site.</summary>
    public const int WordsPerSite = 3;

    /// <param name="register">Gives the number of a new site, counted from 1.</param>
    public static ShaderBinary Apply(ShaderBinary binary, Func<BoundsSite, uint> register)
    {
        SpirVIndex index = new(new SpirVModule(binary.SpirV));
        Rewriter rewriter = new(index, binary.EntryPoint, register);
        if (!rewriter.CheckAll())
        {
            return binary;
        }
        int binding = binary.Resources.Select(r => r.Binding).DefaultIfEmpty(-1).Max() + 1;
        rewriter.ReportAtEnd(binary.DescriptorSet, binding);
        byte[] bytes = index.Module.ToBytes();
        ShaderResource log = new(LogName, ResourceKind.RWStructuredBuffer, binding, 0, sizeof(uint), [], "");
        return binary with { SpirV = bytes, Hash = ShaderReflector.Hash(bytes), Resources = [.. binary.Resources, log] };
    }

    private sealed class Rewriter
    {
        private readonly SpirVIndex index;
        private readonly ModuleEditor editor;
        private readonly string shader;
        private readonly Func<BoundsSite, uint> register;
        private readonly Dictionary<uint, SpirVInstruction> pointers = [];
        private readonly uint[] kept;
        private readonly List<SpirVInstruction> output = [];

        public Rewriter(SpirVIndex index, string shader, Func<BoundsSite, uint> register)
        {
            (this.index, this.shader, this.register) = (index, shader, register);
            editor = new ModuleEditor(index);
            uint zero = editor.Constant(0);
            kept = [.. Enumerable.Range(0, WordsPerSite).Select(_ => editor.Variable(SpirVStorage.Private, editor.UInt, zero))];
        }

        private SpirVModule Module => index.Module;

        /// <summary>False when nothing is indexed.</summary>
        public bool CheckAll()
        {
            // What the checks use is made first: it belongs before the functions.
            _ = editor.Bool;
            List<SpirVInstruction> all = [.. Module.Instructions];
            Dictionary<SpirVInstruction, List<SpirVInstruction>> checks = [];
            foreach (SpirVInstruction i in all)
            {
                if (i.Op is SpirVOp.Variable or SpirVOp.AccessChain or SpirVOp.InBoundsAccessChain or SpirVOp.FunctionParameter)
                {
                    pointers[i[1]] = i;
                }
                if (i.Op is SpirVOp.AccessChain or SpirVOp.InBoundsAccessChain)
                {
                    output.Clear();
                    Check(i);
                    if (output.Count > 0)
                    {
                        checks[i] = [.. output];
                    }
                }
            }
            List<SpirVInstruction> rewritten = [];
            foreach (SpirVInstruction i in Module.Instructions)
            {
                if (checks.TryGetValue(i, out List<SpirVInstruction>? before))
                {
                    rewritten.AddRange(before);
                }
                rewritten.Add(i);
            }
            Module.Instructions.Clear();
            Module.Instructions.AddRange(rewritten);
            return checks.Count > 0;
        }

        public void ReportAtEnd(int set, int binding)
        {
            uint array = editor.NewType(SpirVOp.TypeRuntimeArray, editor.UInt);
            uint block = editor.NewType(SpirVOp.TypeStruct, array);
            uint log = editor.Variable(SpirVStorage.StorageBuffer, block);
            editor.Decorate(array, (uint)SpirVDecoration.ArrayStride, sizeof(uint));
            editor.Decorate(block, (uint)SpirVDecoration.Block);
            Module.Instructions.Insert(
                index.FirstType(), new SpirVInstruction(SpirVOp.MemberDecorate, block, 0, (uint)SpirVDecoration.Offset, 0));
            editor.Decorate(log, (uint)SpirVDecoration.DescriptorSet, (uint)set);
            editor.Decorate(log, (uint)SpirVDecoration.Binding, (uint)binding);
            uint report = editor.AddFunction(Report(log));
            int at = editor.EntryFunction();
            bool inEntry = true;
            for (; at < Module.Instructions.Count; at++)
            {
                SpirVInstruction i = Module.Instructions[at];
                inEntry &= i.Op != SpirVOp.FunctionEnd;
                if (i.Op == SpirVOp.Return && inEntry)
                {
                    Module.Instructions.Insert(at++, editor.Call(report));
                }
            }
            for (at = Module.Instructions.Count - 1; at >= 0; at--)
            {
                if (Module.Instructions[at].Op == SpirVOp.Kill)
                {
                    Module.Instructions.Insert(at, editor.Call(report));
                }
            }
        }

        private List<SpirVInstruction> Report(uint log)
        {
            uint[] loaded = [.. kept.Select(_ => Module.NewId())];
            (uint fault, uint write, uint end, uint first) = (Module.NewId(), Module.NewId(), Module.NewId(), Module.NewId());
            List<SpirVInstruction> body = [new(SpirVOp.Label, Module.NewId())];
            body.AddRange(kept.Select((variable, i) => new SpirVInstruction(SpirVOp.Load, editor.UInt, loaded[i], variable)));
            body.Add(new(SpirVOp.INotEqual, editor.Bool, fault, loaded[0], editor.Constant(0)));
            body.Add(new(SpirVOp.SelectionMerge, end, 0));
            body.Add(new(SpirVOp.BranchConditional, fault, write, end));
            body.Add(new(SpirVOp.Label, write));
            body.Add(new(SpirVOp.IMul, editor.UInt, first, loaded[0], editor.Constant(WordsPerSite)));
            body.Add(new(
                SpirVOp.AtomicIAdd, editor.UInt, Module.NewId(), Word(body, log, first, 0), editor.Constant(1), editor.Constant(0),
                editor.Constant(1)));
            body.Add(new(SpirVOp.Store, Word(body, log, first, 1), loaded[1]));
            body.Add(new(SpirVOp.Store, Word(body, log, first, 2), loaded[2]));
            body.Add(new(SpirVOp.Branch, end));
            body.Add(new(SpirVOp.Label, end));
            body.Add(new(SpirVOp.Return));
            return body;
        }

        private uint Word(List<SpirVInstruction> body, uint log, uint first, uint offset)
        {
            (uint at, uint element) = (Module.NewId(), Module.NewId());
            body.Add(new(SpirVOp.IAdd, editor.UInt, at, first, editor.Constant(offset)));
            uint pointer = editor.Pointer(SpirVStorage.StorageBuffer, editor.UInt);
            body.Add(new(SpirVOp.AccessChain, pointer, element, log, editor.Constant(0), at));
            return element;
        }

        private void Check(SpirVInstruction chain)
        {
            if (!pointers.TryGetValue(chain[2], out SpirVInstruction? origin))
            {
                return;
            }
            uint type = index.Definition(origin[0])[2];
            uint member = 0;
            for (int operand = 3; operand < chain.Operands.Length; operand++)
            {
                SpirVInstruction definition = index.Definition(type);
                switch (definition.Op)
                {
                    case SpirVOp.TypeStruct:
                        member = index.ConstantValue(chain[operand]);
                        type = definition[(int)member + 1];
                        continue;
                    case SpirVOp.TypeRuntimeArray when operand == 4 && origin.Op == SpirVOp.Variable:
                        uint length = Module.NewId();
                        output.Add(new(SpirVOp.ArrayLength, editor.UInt, length, chain[2], member));
                        Compare(chain, chain[operand], length);
                        break;
                    case SpirVOp.TypeArray:
                        CheckFixed(chain, chain[operand], index.ArrayLength(definition));
                        break;
                    case SpirVOp.TypeVector or SpirVOp.TypeMatrix:
                        CheckFixed(chain, chain[operand], definition[2]);
                        break;
                }
                type = definition[1];
            }
        }

        private void CheckFixed(SpirVInstruction chain, uint at, uint length)
        {
            bool known = Module.Instructions.Exists(i => i.Op == SpirVOp.Constant && i[1] == at);
            if (!known || index.ConstantValue(at) >= length)
            {
                Compare(chain, at, editor.Constant(length));
            }
        }

        // fault = at >= length and none before: site, index and length are kept by selects, without a branch.
        private void Compare(SpirVInstruction chain, uint at, uint length)
        {
            uint site = editor.Constant(register(new BoundsSite(shader, Name(chain[2]))));
            (uint outside, uint before, uint none, uint fault, uint value) =
                (Module.NewId(), Module.NewId(), Module.NewId(), Module.NewId(), Module.NewId());
            output.Add(new(SpirVOp.UGreaterThanEqual, editor.Bool, outside, at, length));
            output.Add(new(SpirVOp.Load, editor.UInt, before, kept[0]));
            output.Add(new(SpirVOp.IEqual, editor.Bool, none, before, editor.Constant(0)));
            output.Add(new(SpirVOp.LogicalAnd, editor.Bool, fault, outside, none));

            // An index may be signed: the sum has the result's type.
            output.Add(new(SpirVOp.IAdd, editor.UInt, value, at, editor.Constant(0)));
            Keep(kept[0], fault, site);
            Keep(kept[1], fault, value);
            Keep(kept[2], fault, length);
        }

        private void Keep(uint variable, uint fault, uint value)
        {
            (uint old, uint chosen) = (Module.NewId(), Module.NewId());
            output.Add(new(SpirVOp.Load, editor.UInt, old, variable));
            output.Add(new(SpirVOp.Select, editor.UInt, chosen, fault, value, old));
            output.Add(new(SpirVOp.Store, variable, chosen));
        }

        private string Name(uint pointer)
        {
            while (pointers.TryGetValue(pointer, out SpirVInstruction? origin) && origin.Op is SpirVOp.AccessChain or SpirVOp.InBoundsAccessChain)
            {
                pointer = origin![2];
            }
            string name = index.Name(pointer);
            return name.Length > 0 ? name : "an array";
        }
    }
}
