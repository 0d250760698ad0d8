package org.sami.crw.cli.run;

import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.JournalConverter;
import org.sami.crw.cli.option.LinkOptions;
import org.sami.crw.cli.option.OutputOptions;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.RunOptions;
import org.sami.crw.cli.option.SecondsConverter;
import org.sami.crw.cli.option.SpeedConverter;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.journal.JournalAddress;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw resume}: goes on with a run whose process ended. */
@Command(
        name = "resume",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description =
                "Resumes a run that has a journal, from the point where its process ended. The plan and all settings"
                        + " are the journal's; the result is the same as without the interruption.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the mission ended",
            "2:wrong usage, or a file that cannot be read",
            "3:the mission was aborted",
            "4:the mission or the program failed, or the run cannot be resumed",
            "5:the mission was still running when the run was stopped (--for, Ctrl-C)",
            "6:the mission ended, with problems that are named"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw resume visit.journal", "  crw resume visit.journal --speed max --json"})
public final class ResumeCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private LinkOptions links = new LinkOptions();

    @Parameters(
            paramLabel = "JOURNAL",
            converter = JournalConverter.class,
            description = "The file that 'crw run --journal' wrote, or postgresql://HOST:PORT/DATABASE.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private JournalAddress journal;

    @Option(
            names = "--speed",
            paramLabel = "X|max",
            converter = SpeedConverter.class,
            description = "Another speed than the recorded one.")
    private @Nullable Speed speed;

    @Option(
            names = "--for",
            paramLabel = "SECONDS",
            converter = SecondsConverter.class,
            description = "Stop after so much simulated time since the start of the run. Without it the recorded --for "
                    + "holds, unless the run has reached it already: then it continues to its end.")
    private @Nullable Long limitMillis;

    @Option(
            names = "--connect",
            paramLabel = "HOST:PORT,...",
            description =
                    "Present addresses of the boats' servers, if they have changed. For runs with --connect only.")
    private @Nullable String connect;

    @Option(
            names = "--connect-within",
            paramLabel = "SECONDS",
            defaultValue = "30",
            converter = SecondsConverter.class,
            description = "How long such boats may take to answer (default ${DEFAULT-VALUE}). The run continues "
                    + "without the others, but not without any boat.")
    private long connectWithinMillis;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private OutputOptions output;

    @Override
    public Integer call() throws Exception {
        links.use();
        return new Execution(spec.commandLine(), PlanSource.library(), output, connectWithinMillis)
                .resume(journal, this::changed);
    }

    private RunSettings changed(RunSettings recorded) {
        List<BoatAddress> addresses = RunOptions.addressesOf(connect);
        if (!addresses.isEmpty() && !recorded.isConnected()) {
            throw new UsageFault("--connect: the boats of this run are in its own process");
        }
        if (recorded.isConnected() && speed != null && !speed.equals(Speed.REAL)) {
            throw new UsageFault("--speed: boats that are connected run at speed 1, not " + speed);
        }
        RunSettings other = addresses.isEmpty() ? recorded : recorded.connectedTo(addresses);
        other = speed == null ? other : other.withSpeed(speed);
        return limitMillis == null ? other : other.withLimit(OptionalLong.of(limitMillis));
    }
}
