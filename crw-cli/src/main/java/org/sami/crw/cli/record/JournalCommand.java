package org.sami.crw.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.JournalConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.json.GlobalsFile;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.json.Reading;
import org.sami.spn.json.ValueJson;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw journal}: what a session knew after any entry of its journal. Changes nothing; a writer may be running. */
@Command(
        name = "journal",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = "Shows the state of a session after any entry of its journal: missions with their tokens, open"
                + " decisions, interrupts, and why each transition of a marked place cannot fire. Or saves the"
                + " values that global variables had then to a project's file. Or, of one or several journals,"
                + " prints what the missions of each plan needed.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:shown, or saved",
            "1:the project cannot be read, or gives a global another type; nothing was saved",
            "2:wrong usage, or there is no such file",
            "4:the journal cannot be read"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw journal clv.journal",
            "  crw journal clv.journal --at 5",
            "  crw journal clv.journal --entries",
            "  crw journal clv.journal --save-globals lake.json",
            "  crw journal monday.journal tuesday.journal --statistics"
        })
public final class JournalCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            paramLabel = "JOURNAL",
            arity = "1..*",
            converter = JournalConverter.class,
            description = "A file that 'crw run --journal' or 'crw session --journal' wrote, or"
                    + " postgresql://HOST:PORT/DATABASE; several with --statistics.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private List<JournalAddress> files;

    @Option(
            names = "--at",
            paramLabel = "ENTRY",
            description = "After which entry; 0 is before the first (default: the last).")
    private @Nullable Long at;

    @Option(names = "--entries", description = "List the entries instead, one line each.")
    private boolean entries;

    @Option(
            names = "--save-globals",
            paramLabel = "PROJECT",
            description =
                    "Make the values that global variables had after that entry the initial values in this project's"
                            + " file, and list what changes.")
    private @Nullable Path saveGlobals;

    @ArgGroup(exclusive = false)
    private @Nullable StatisticsOptions statistics;

    @Override
    public Integer call() throws IOException {
        for (JournalAddress one : files) {
            if (!one.exists()) {
                throw new UsageFault("there is no journal " + one);
            }
        }
        if (statistics != null) {
            if (at != null || entries || saveGlobals != null) {
                throw new UsageFault(
                        "--statistics is of whole journals: give it without --at, --entries, --save-globals");
            }
            return statistics.print(files, spec.commandLine());
        }
        if (files.size() > 1) {
            throw new UsageFault("several journals are read with --statistics only");
        }
        JournalAddress file = files.get(0);
        PrintWriter out = spec.commandLine().getOut();
        try (JournalReader journal = file.read()) {
            long last = journal.lastIndex();
            long index = at == null ? last : at;
            if (index < 0 || index > last) {
                throw new UsageFault("--at is 0 to " + last + ", the last entry of " + file + ", not " + index);
            }
            journal.recovery()
                    .damage()
                    .ifPresent(damage -> spec.commandLine().getErr().println("crw: " + damage));
            if (entries && saveGlobals != null) {
                throw new UsageFault("--entries lists, --save-globals saves: give one of them");
            }
            if (entries) {
                journal.entries(1, index, entry -> out.println(line(entry)));
            } else {
                Engine engine = JournalPlans.engine(file, journal.header());
                EngineState state = journal.stateAt(index, engine);
                if (saveGlobals != null) {
                    return save(engine.view(state).globals(), saveGlobals, engine.vocabulary());
                }
                out.printf("entry %d of %d, after %s%n", index, last, StateText.time(state.nowMillis()));
                new StateText(engine.view(state)).print(out);
            }
        }
        out.flush();
        spec.commandLine().getErr().flush();
        return ExitCode.OK;
    }

    private int save(Map<String, Value> globals, Path project, Vocabulary vocabulary) throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        Reading<List<GlobalsFile.Change>> saved = new GlobalsFile(vocabulary).save(globals, project);
        FindingsText.print(spec.commandLine().getErr(), project.toString(), saved.findings());
        saved.result().ifPresent(changes -> {
            changes.forEach(change -> out.printf(
                    "%s: %s, before %s%n",
                    change.name(),
                    text(change.after(), change, vocabulary),
                    change.before()
                            .map(before -> text(before, change, vocabulary))
                            .orElse("without a value")));
            out.printf("%d of %d globals changed in %s%n", changes.size(), globals.size(), project);
        });
        out.flush();
        spec.commandLine().getErr().flush();
        return saved.result().isPresent() ? ExitCode.OK : ExitCode.FINDINGS;
    }

    private static String text(Value value, GlobalsFile.Change change, Vocabulary vocabulary) {
        return ValueJson.write(value, change.type(), vocabulary.types()).toString();
    }

    /** The document of a loaded project is long, and named by its SHA-256 instead. */
    private static String line(JournalEntry entry) {
        String input = entry.input() instanceof Input.LoadProject load
                ? "{\"input\":\"load-project\",\"sha256\":\"" + load.sha256() + "\"}"
                : ProtocolJson.inputText(entry.input());
        return entry.index() + "  " + StateText.time(entry.atMillis()) + "  " + input;
    }
}
