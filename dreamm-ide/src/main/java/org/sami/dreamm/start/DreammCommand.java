package org.sami.dreamm.start;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.profile.ProfileFile;
import org.sami.ui.window.LookOptions;
import org.sami.ui.window.WindowStart;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** The command line of DREAMM. */
@Command(
        name = "dreamm",
        mixinStandardHelpOptions = true,
        description = "Opens DREAMM, the window in which plans are written, with the library of plans or a project.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  dreamm",
            "  dreamm station-keep",
            "  dreamm my-beach.json --theme dark",
            "  dreamm --learn",
            "  dreamm --domain rovers rovers/plans/look.json"
        })
public final class DreammCommand implements Callable<Integer> {
    private final Opening opening;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            arity = "0..1",
            paramLabel = "PLAN|PROJECT",
            description = "A plan of the library by its id, or the file or folder of a project; else the library.")
    private @Nullable String open;

    @Option(
            names = "--domain",
            paramLabel = "NAME|FOLDER",
            description = "The words that plans are made of: uav or team, which ship, or a folder with a domain.json;"
                    + " else those of the boats.")
    private @Nullable Path domain;

    @Option(
            names = "--profile",
            paramLabel = "FILE",
            description = "Hides and locks what the file says, as for a lesson.")
    private @Nullable Path profile;

    @Option(names = "--learn", description = "Opens the course, where you left it.")
    private boolean learn;

    @Option(
            names = "--learner",
            paramLabel = "NAME",
            description = "Opens the course where NAME left it; several can learn on one machine.")
    private @Nullable String learner;

    @Option(
            names = "--data",
            paramLabel = "DIR",
            description = "Where settings, the arrangement of panels and unsaved work are kept; else the user's data"
                    + " directory.")
    private @Nullable Path data;

    @Mixin
    private LookOptions look = new LookOptions();

    /** What opens the window, once the command line is understood. */
    @FunctionalInterface
    public interface Opening {
        /**
         * Opens it; returns once it is there.
         *
         * @throws IOException with one sentence for the author
         */
        void open(DreammOptions options, FirstProject first, AuthorDirectory data) throws IOException;
    }

    /** A command that is not parsed yet. */
    public DreammCommand(Opening opening) {
        this.opening = Objects.requireNonNull(opening, "opening");
    }

    @Override
    public Integer call() {
        return WindowStart.open(spec, this::open);
    }

    private void open() throws IOException {
        DreammOptions options = options();
        FirstProject first = FirstProject.open(options);
        opening.open(options, first, AuthorDirectory.open(data == null ? AuthorDirectory.ofUser() : data));
    }

    private DreammOptions options() throws IOException {
        boolean course = learn || learner != null;
        if (course && (open != null || domain != null || profile != null)) {
            throw new IOException("--learn opens the plans of the course: no plan, --domain or --profile goes with it");
        }
        return new DreammOptions(
                Optional.ofNullable(open),
                Optional.ofNullable(domain),
                profile == null ? Profile.ALL : ProfileFile.read(profile),
                look.theme(),
                look.scale(),
                new LearnOptions(course, Optional.ofNullable(learner)));
    }
}
