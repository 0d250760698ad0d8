package org.sami.crw.gui;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.OperatorCommand;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.palette.Theme;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.check.WindowRobot;
import picocli.CommandLine;

/** The real window over a session of its own, as its program opens it; for tests only. */
public final class OpenedWindow implements AutoCloseable {
    private static final String BEACH = "/org/sami/domain/crw/deployments/katara-beach.json";
    private static final int WITHIN_S = 300;

    private final CompletableFuture<Integer> ended;
    private final OperatorWindow window;

    private OpenedWindow(CompletableFuture<Integer> ended, OperatorWindow window) {
        this.ended = ended;
        this.window = window;
    }

    /**
     * Opens one.
     *
     * @param boats addresses of servers; none = the built-in fleet
     * @param project file of the plans; empty = Katara Beach
     * @param resume whether an unfinished session goes on
     * @param data directory of the window
     */
    public static OpenedWindow open(List<BoatAddress> boats, Optional<Path> project, boolean resume, Path data)
            throws IOException {
        return open(
                new StartOptions(boats, project, Optional.of(Theme.LIGHT), Optional.of(100), Optional.of(resume)),
                data);
    }

    /** Opens one over the built-in fleet and Katara Beach, at the normal scale; it does not go on with a session. */
    public static OpenedWindow onBuiltInFleet(Path data) throws IOException {
        return over(List.of(), data);
    }

    /** Opens one over servers and Katara Beach, at the normal scale; it does not go on with a session. */
    public static OpenedWindow over(List<BoatAddress> boats, Path data) throws IOException {
        return open(boats, Optional.empty(), false, data);
    }

    /**
     * Opens one as its command does.
     *
     * @param args of the command
     * @throws AssertionError if the command ends otherwise than with 0
     */
    public static OpenedWindow byCommand(List<String> args) throws Exception {
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        CompletableFuture<OperatorWindow> opened = new CompletableFuture<>();
        int code = new CommandLine(new OperatorCommand(
                        (options, data) -> opened.complete(WindowStart.open(options, data, ended::complete))))
                .execute(args.toArray(String[]::new));
        if (code != 0) {
            throw new AssertionError("the command ends with " + code);
        }
        return new OpenedWindow(ended, opened.get(WITHIN_S, TimeUnit.SECONDS));
    }

    /** Opens one as options say. */
    public static OpenedWindow open(StartOptions options, Path data) throws IOException {
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        return new OpenedWindow(ended, WindowStart.open(options, DataDirectory.open(data), ended::complete));
    }

    /** Starts the window's program where a session was not finished, and has it ask whether that goes on; gives its exit code once it has ended. */
    public static CompletableFuture<Integer> ask(Path data) {
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        StartOptions options = new StartOptions(
                List.of(), Optional.empty(), Optional.of(Theme.LIGHT), Optional.of(100), Optional.empty());
        Thread main = new Thread(
                () -> {
                    try {
                        WindowStart.open(options, DataDirectory.open(data), ended::complete);
                    } catch (IllegalStateException left) {
                        // the question was left; all is closed
                    } catch (IOException | RuntimeException fault) {
                        ended.completeExceptionally(fault);
                    }
                },
                "asks whether a session goes on");
        main.setDaemon(true);
        main.start();
        return ended;
    }

    /** The beach's project with all plans of the library. */
    public static Project beachWithLibrary() {
        Project beach;
        try (InputStream text = OpenedWindow.class.getResourceAsStream(BEACH)) {
            beach = new ProjectReader(SessionWorld.LIBRARY.vocabulary())
                    .readAndCheck(new String(text.readAllBytes(), StandardCharsets.UTF_8))
                    .orThrow();
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
        Project library = SessionWorld.LIBRARY.combined();
        List<Plan> plans = new ArrayList<>(beach.plans());
        library.plans().stream().filter(plan -> beach.plan(plan.id()).isEmpty()).forEach(plans::add);
        List<MissionTreeNode> tree = new ArrayList<>(beach.missionTree());
        library.missionTree().forEach(node -> without(node, beach).ifPresent(tree::add));
        return beach.withPlans(plans).withMissionTree(tree);
    }

    /** Writes the beach's project with all plans of the library into a file. */
    public static Path writeBeachWithLibrary(Path file) throws IOException {
        new ProjectWriter(SessionWorld.LIBRARY.vocabulary()).write(beachWithLibrary(), file);
        return file;
    }

    /** A node of the library's tree without the plans that the beach has. */
    private static Optional<MissionTreeNode> without(MissionTreeNode node, Project beach) {
        if (node.plan().flatMap(beach::plan).isPresent()) {
            return Optional.empty();
        }
        MissionTreeNode rest = node.withChildren(node.children().stream()
                .flatMap(child -> without(child, beach).stream())
                .toList());
        return rest.plan().isEmpty() && rest.children().isEmpty() ? Optional.empty() : Optional.of(rest);
    }

    /** The window. */
    public OperatorWindow window() {
        return window;
    }

    /** Whether it was closed, and all with it. */
    public boolean hasEnded() {
        return ended.isDone();
    }

    /** Closes it; gives the exit code of its program. */
    public int end() throws Exception {
        if (!ended.isDone()) {
            WindowRobot.ask(() -> {
                window.end();
                return null;
            });
        }
        return ended.get(WITHIN_S, TimeUnit.SECONDS);
    }

    @Override
    public void close() throws Exception {
        end();
    }
}
