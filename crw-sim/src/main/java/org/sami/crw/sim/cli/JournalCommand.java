package org.sami.crw.sim.cli;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalException;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.json.ProtocolJson;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw journal}: what a session knew after any entry of its journal. Changes nothing, also beside a running writer. */
@Command(
        name = "journal",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description =
                "Shows the state of a session after any entry of its journal: missions with their tokens, open decisions, "
                        + "interrupts, and why each transition of a marked place cannot fire.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:shown", "2:wrong usage, or there is no such file", "4:the journal cannot be read"},
        footerHeading = "%nExamples:%n",
        footer = {"  crw journal clv.journal", "  crw journal clv.journal --at 5", "  crw journal clv.journal --entries"
        })
final class JournalCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "JOURNAL", description = "A file that 'crw run --journal' wrote.")
    private Path file;

    @Option(
            names = "--at",
            paramLabel = "ENTRY",
            description = "After which entry; 0 is before the first (default: the last).")
    private Long at;

    @Option(names = "--entries", description = "List the entries instead, one line each.")
    private boolean entries;

    @Override
    public Integer call() throws JournalException {
        if (!Files.isRegularFile(file)) {
            throw new UsageFault("there is no journal " + file);
        }
        PrintWriter out = spec.commandLine().getOut();
        try (JournalReader journal = JournalReader.open(file)) {
            long last = journal.lastIndex();
            long index = at == null ? last : at;
            if (index < 0 || index > last) {
                throw new UsageFault("--at is 0 to " + last + ", the last entry of " + file + ", not " + index);
            }
            journal.recovery()
                    .damage()
                    .ifPresent(damage -> spec.commandLine().getErr().println("crw: " + damage));
            if (entries) {
                journal.entries(1, index, entry -> out.println(line(entry)));
            } else {
                Engine engine = JournalPlans.engine(file, journal.header());
                EngineState state = journal.stateAt(index, engine);
                out.printf("entry %d of %d, after %s%n", index, last, StateText.time(state.nowMillis()));
                new StateText(engine.project(), engine.view(state)).print(out);
            }
        }
        out.flush();
        spec.commandLine().getErr().flush();
        return ExitCode.OK;
    }

    private static String line(JournalEntry entry) {
        return entry.index() + "  " + StateText.time(entry.atMillis()) + "  " + ProtocolJson.inputText(entry.input());
    }
}
