package org.sami.crw.sim.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import org.sami.crw.sim.run.RunSettings;
import org.sami.crw.sim.run.Speed;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw demo}: the main job, to be watched: three boats visit twelve locations. */
@Command(
        name = "demo",
        mixinStandardHelpOptions = true,
        description =
                "Runs the plan 'clv' on three simulated boats, which visit twelve locations, so fast that it is over "
                        + "within half a minute or so; shows it and writes a report with a picture.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:the mission ended", "3:it was aborted", "4:it failed", "5:it was stopped before its end"},
        footerHeading = "%nExample:%n",
        footer = {"  crw demo --report demo"})
final class DemoCommand implements Callable<Integer> {
    private static final String PLAN = "clv";
    /** At the default speed 70 s: the demonstration ends by itself, whatever happens in it. */
    private static final long LIMIT_MILLIS = 1_400_000;

    private static final Path BUILD = Path.of("build");

    @Spec
    private CommandSpec spec;

    @Option(
            names = "--report",
            paramLabel = "DIR",
            description = "Where the report goes (default build/demo-report where there is a folder build, "
                    + "else a new temporary folder).")
    private Path folder;

    @Option(
            names = "--speed",
            paramLabel = "X|max",
            defaultValue = "20",
            converter = SpeedConverter.class,
            description = "Simulated seconds in one second (default ${DEFAULT-VALUE}).")
    private Speed speed;

    @Override
    public Integer call() throws Exception {
        Path reports = folder != null
                ? folder
                : Files.isDirectory(BUILD) ? BUILD.resolve("demo-report") : Files.createTempDirectory("crw-demo");
        DomainLibrary library = PlanSource.library();
        PlanSource source = PlanSource.find(PLAN, library);
        Plan plan = source.choose(PLAN);
        RunSettings settings = new RunSettings(
                plan.id(),
                plan.name(),
                new RunSettings.Fleet(3, 12, 600, 1),
                speed,
                OptionalLong.of(LIMIT_MILLIS),
                Map.of(),
                5_000,
                "");
        return new Execution(spec.commandLine(), library, OutputOptions.toFolder(reports))
                .runNew(source, plan, settings, null);
    }
}
