package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import raytracing.CompilerLog.Compilation;
import raytracing.CompilerLog.Trap;

/** A small log in the form in which HotSpot of JDK 17 writes it. */
class CompilerLogTest {
    private static final String LOG = """
        <?xml version='1.0' encoding='UTF-8'?>
        <hotspot_log version='160 1'>
        <task_queued compile_id='7' method='a.b.Big run (I)V' bytes='60' count='1' level='3' stamp='0.010'/>
        <make_not_entrant thread='5' reason='x' compile_id='9' compiler='c2' level='4' stamp='0.300'/>
        <make_not_entrant thread='5' reason='x' compile_id='7' compiler='c1' level='3' stamp='0.300'/>
        <uncommon_trap thread='5' reason='unstable_if' action='reinterpret' compile_id='9' level='4' stamp='0.290'>
        <jvms bci='3' method='a.b.Small get ()D' bytes='20' count='1'/>
        <jvms bci='8' method='a.b.Big run (I)V' bytes='60' count='1'/>
        </uncommon_trap>
        <compilation_log thread='9'>
        <start_compile_thread name='C2 CompilerThread0' thread='9' stamp='0.010'/>
        <task compile_id='9' method='a.b.Big run (I)V' bytes='60' count='5000' stamp='0.100'>
        <phase name='parse' stamp='0.100'>
        <klass id='1' name='a.b.Big' flags='1'/>
        <klass id='2' name='a.b.Small' flags='1'/>
        <method id='3' holder='1' name='run' bytes='60'/>
        <parse method='3' uses='5000' stamp='0.100'>
        <uncommon_trap bci='2' reason='null_check' action='maybe_recompile'/>
        <method id='4' holder='2' name='get' bytes='20'/>
        <call method='4' count='5000'/>
        <parse method='4' uses='5000' stamp='0.101'><parse_done stamp='0.101'/></parse>
        <parse method='4' uses='5000' stamp='0.102'><parse_done stamp='0.102'/></parse>
        <parse_done stamp='0.103'/>
        </parse>
        <phase_done name='parse' stamp='0.110'/>
        </phase>
        <task_done success='1' nmsize='900' count='5000' inlined_bytes='40' stamp='0.125'/>
        </task>
        <task compile_id='7' method='a.b.Big run (I)V' bytes='60' count='200' level='3' stamp='0.020'>
        <task_done success='1' nmsize='2000' count='200' stamp='0.022'/>
        </task>
        </compilation_log>
        </hotspot_log>
        """;

    @TempDir
    Path folder;

    private CompilerLog log() throws IOException {
        return CompilerLog.of(Files.writeString(folder.resolve("log.xml"), LOG));
    }

    @Test
    void aCompilationHasTierTimeAndSizes() throws IOException {
        List<Compilation> optimised = log().ofTiers(4, 4);
        assertEquals(1, optimised.size());
        Compilation big = optimised.get(0);
        assertEquals("Big.run", big.method());
        assertEquals(25, big.milliseconds(), 1e-9);
        assertEquals(List.of(60, 40, 900), List.of(big.bytes(), big.inlinedBytes(), big.codeBytes()));
        assertEquals(2, CompilerLog.milliseconds(log().ofTiers(1, 3)), 1e-9);
    }

    @Test
    void copiesOfAnInlinedMethodAreAddedUp() throws IOException {
        assertEquals(Map.of("Small.get", 40), log().ofTiers(4, 4).get(0).inlined());
    }

    /** The traps that the compiler only plans stand in the log too, without a thread. */
    @Test
    void aTrapThatWasTakenNamesTheInnermostMethod() throws IOException {
        assertEquals(List.of(new Trap("Small.get", "unstable_if")), log().traps());
    }

    @Test
    void onlyOptimisedCodeCountsAsThrownAway() throws IOException {
        assertEquals(Map.of("Big.run", 1), log().discarded());
    }
}
