package org.sami.crw.cli;

import java.util.Map;
import org.sami.crw.cli.analysis.AnalyseAllCommand;
import org.sami.crw.cli.analysis.AnalyseCommand;
import org.sami.crw.cli.analysis.GraphCommand;
import org.sami.crw.cli.board.BoardCommand;
import org.sami.crw.cli.defaults.DefaultsCommand;
import org.sami.crw.cli.key.KeysCommand;
import org.sami.crw.cli.key.PeopleCommand;
import org.sami.crw.cli.key.PhoneCommand;
import org.sami.crw.cli.lesson.GradeCommand;
import org.sami.crw.cli.lesson.LessonsCommand;
import org.sami.crw.cli.option.Converters;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.cli.output.LogFormatter;
import org.sami.crw.cli.output.StandardStreams;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.cli.output.Version;
import org.sami.crw.cli.pair.BasePairCommand;
import org.sami.crw.cli.pair.TakeOverCommand;
import org.sami.crw.cli.plan.CheckCommand;
import org.sami.crw.cli.plan.ComponentsCommand;
import org.sami.crw.cli.plan.DrawCommand;
import org.sami.crw.cli.plan.EventsCommand;
import org.sami.crw.cli.plan.MarkupsCommand;
import org.sami.crw.cli.plan.NewCommand;
import org.sami.crw.cli.plan.PhasesCommand;
import org.sami.crw.cli.plan.PlansCommand;
import org.sami.crw.cli.plan.SchemaCommand;
import org.sami.crw.cli.plan.TestCommand;
import org.sami.crw.cli.record.CopyJournalCommand;
import org.sami.crw.cli.record.ExportCommand;
import org.sami.crw.cli.record.ImportLegacyCommand;
import org.sami.crw.cli.record.ImportLocationsCommand;
import org.sami.crw.cli.record.JournalCommand;
import org.sami.crw.cli.record.LogCommand;
import org.sami.crw.cli.record.LogsCommand;
import org.sami.crw.cli.run.BoatServerCommand;
import org.sami.crw.cli.run.DemoCommand;
import org.sami.crw.cli.run.ExperimentCommand;
import org.sami.crw.cli.run.FindCommand;
import org.sami.crw.cli.run.ResumeCommand;
import org.sami.crw.cli.run.RunCommand;
import org.sami.crw.cli.run.ServeCommand;
import org.sami.crw.cli.run.SessionCommand;
import org.sami.crw.cli.run.StopCommand;
import org.sami.crw.cli.vehicle.VehiclesCommand;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The command {@code crw}: team plans for boats, run without a window. */
@Command(
        name = "crw",
        description = "Checks team plans and runs them on simulated boats.",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        synopsisSubcommandLabel = "COMMAND",
        subcommands = {
            PlansCommand.class,
            NewCommand.class,
            CheckCommand.class,
            SchemaCommand.class,
            TestCommand.class,
            LessonsCommand.class,
            GradeCommand.class,
            DrawCommand.class,
            PhasesCommand.class,
            AnalyseCommand.class,
            AnalyseAllCommand.class,
            GraphCommand.class,
            EventsCommand.class,
            MarkupsCommand.class,
            ComponentsCommand.class,
            DefaultsCommand.class,
            RunCommand.class,
            ExperimentCommand.class,
            ResumeCommand.class,
            SessionCommand.class,
            ServeCommand.class,
            BasePairCommand.class,
            TakeOverCommand.class,
            PeopleCommand.class,
            JournalCommand.class,
            CopyJournalCommand.class,
            ExportCommand.class,
            DemoCommand.class,
            BoatServerCommand.class,
            BoardCommand.class,
            VehiclesCommand.class,
            FindCommand.class,
            StopCommand.class,
            LogsCommand.class,
            KeysCommand.class,
            PhoneCommand.class,
            ImportLegacyCommand.class,
            LogCommand.class,
            ImportLocationsCommand.class,
            CompletionCommand.class,
            CommandLine.HelpCommand.class
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:done; the mission ended",
            "1:a plan or file has errors (findings)",
            "2:wrong usage, or a file that cannot be read",
            "3:the mission was aborted",
            "4:the mission or the program failed",
            "5:the mission was still running when the run was stopped",
            "6:the mission ended, with problems that are named"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw demo               a demonstration of about a minute",
            "  crw plans              lists the plans",
            "  crw run clv --boats 5 --locations 30 --speed max --report out",
            "  crw check my-plan.json",
            "  crw events             lists the events of plans",
            "",
            "'crw help COMMAND' describes one of them."
        })
public final class Crw implements Runnable {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private GlobalOptions options = new GlobalOptions();

    @Override
    public void run() {
        throw new ParameterException(
                spec.commandLine(),
                "Which command? One of " + String.join(", ", spec.subcommands().keySet()) + ".");
    }

    /** The command line, ready to be executed in any process. */
    public static CommandLine commandLine() {
        Crw crw = new Crw();
        CommandLine line = new CommandLine(crw);
        Converters.addTo(line).setParameterExceptionHandler(ErrorMessages::onWrongUsage);
        line.setExecutionExceptionHandler(ErrorMessages::onException);
        line.setColorScheme(
                CommandLine.Help.defaultColorScheme(CommandLine.Help.Ansi.OFF)); // no output has escape sequences
        line.setExecutionStrategy(parsed -> crw.options.execute(line, parsed));
        return line;
    }

    /**
     * Executes a command line with what the person's configuration file sets.
     *
     * @param environment of the process
     * @return the exit code
     */
    static int execute(CommandLine line, Map<String, String> environment, String... args) {
        try {
            line.setDefaultValueProvider(Configuration.read(line, environment, args));
        } catch (UsageFault fault) {
            return ErrorMessages.onException(fault, line, null);
        }
        try {
            return line.execute(args);
        } catch (Error fault) {
            return ErrorMessages.onError(fault, line);
        }
    }

    /** Runs the command and ends the process with its exit code. */
    public static void main(String[] args) {
        System.setProperty("java.awt.headless", "true");
        StandardStreams.speakUtf8();
        CommandLine line = commandLine();
        LogFormatter.install();
        int code = execute(line, System.getenv(), args);
        System.exit(ErrorMessages.checkOutput(line, System.out, code));
    }
}
