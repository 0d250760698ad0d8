package org.sami.crw.gui.start;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.ConditionsConverter;
import org.sami.crw.cli.option.JournalConverter;
import org.sami.crw.cli.option.LayerOptions;
import org.sami.crw.cli.option.LinkOptions;
import org.sami.crw.cli.option.LostLinkOption;
import org.sami.crw.cli.option.NetworkOption;
import org.sami.crw.cli.option.VesselsFile;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.cli.run.RemoteOptions;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.FileTooLargeException;
import org.sami.ui.window.LookOptions;
import org.sami.ui.window.WindowStart;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The command line of the operator's window. */
@Command(
        name = "crw-operator",
        mixinStandardHelpOptions = true,
        description = {
            "Opens the operator's window. Without boats it brings five simulated ones at Katara Beach.",
            "'demo' instead of options runs the headless demonstration, any other command of crw that command."
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw-operator",
            "  crw-operator --connect 10.0.0.11:11411,10.0.0.12:11411 --project my-beach.json",
            "  crw-operator --keys ~/fleet-keys --connect 10.0.0.11:11411   to boats that are paired (Boats > Pair a"
                    + " boat)",
            "  crw-operator --near          boats on the local network are listed, and connected with one press",
            "  crw-operator --boats boats.txt --data /media/laptop/today --theme sun",
            "  crw-operator --session wss://10.0.0.5:8443 --person anna --key-file anna.key   a session that 'crw"
                    + " serve' runs elsewhere",
            "  crw-operator --replay today.journal --at 90"
        })
public final class OperatorCommand implements Callable<Integer> {
    private final Opening opening;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--connect",
            paramLabel = "ADDRESS",
            split = ",",
            description = "Boats to connect to: HOST:PORT, or mavlink:... for ArduPilot boats.")
    private List<String> connect = new ArrayList<>();

    @Option(
            names = "--boats",
            paramLabel = "FILE",
            description = "The same from a file: addresses on each line, # begins a remark.")
    private @Nullable Path boatsFile;

    @Mixin
    private LostLinkOption lostLink = new LostLinkOption();

    @Option(
            names = "--near",
            description = "Begin without simulated boats, with the list of boats that announce themselves on the local"
                    + " network open.")
    private boolean near;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private NetworkOption network;

    @Option(
            names = "--domain",
            paramLabel = "NAME",
            defaultValue = StartOptions.BOATS,
            description = "Whose plans are run: uav opens the window on five simulated copters, "
                    + "team on three boats and two copters (default: the boats').")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String domain;

    @Option(names = "--project", paramLabel = "FILE", description = "A project's file or folder; else Katara Beach.")
    private @Nullable Path project;

    @Option(
            names = "--conditions",
            paramLabel = "NAME",
            converter = ConditionsConverter.class,
            description =
                    "The water of simulated boats, and the errors of boats that do not report theirs: calm, field "
                            + "or rough; paths keep that distance from no-go areas (default: calm for simulated boats, "
                            + "else field; of a session that is resumed, its own).")
    private @Nullable NamedConditions conditions;

    @Option(
            names = "--vessels",
            paramLabel = "FILE",
            description = "Other vessels and drifting objects on the water of simulated boats (JSON; see"
                    + " docs/command-line.md), from the launch of the first boat on.")
    private @Nullable Path vessels;

    @Mixin
    private LayerOptions layers = new LayerOptions();

    @Option(
            names = "--data",
            paramLabel = "DIR",
            description =
                    "Where journals, settings and the arrangement of panels are kept; else the user's data directory.")
    private @Nullable Path data;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private LinkOptions links;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private LookOptions look;

    @Mixin
    private RemoteOptions remote = new RemoteOptions();

    @Option(
            names = "--resume",
            negatable = true,
            description =
                    "Go on with the session that was not finished, or (--no-resume) begin a new one, without being"
                            + " asked.")
    private @Nullable Boolean resume;

    @Option(
            names = "--replay",
            paramLabel = "JOURNAL",
            converter = JournalConverter.class,
            description = {
                "Show what was, at any moment of a session's journal, instead of opening a session: a file, or",
                "postgresql://HOST:PORT/DATABASE."
            })
    private @Nullable JournalAddress replay;

    @Option(
            names = "--at",
            paramLabel = "SECONDS",
            description = "With --replay: at which moment it begins, in seconds since the session's start.")
    private @Nullable Double at;

    /** What opens the window, once the command line is understood. */
    @FunctionalInterface
    public interface Opening {
        /**
         * Opens it; returns once it is there.
         *
         * @throws IOException with one sentence for the operator
         */
        void open(StartOptions options, DataDirectory data) throws IOException;
    }

    /** A command that is not parsed yet. */
    public OperatorCommand(Opening opening) {
        this.opening = opening;
    }

    @Override
    public Integer call() {
        return WindowStart.open(spec, this::open);
    }

    private void open() throws IOException {
        StartOptions options = options();
        try {
            remote.check(spec.commandLine(), Set.of("--data", "--theme", "--scale"));
            links.use();
        } catch (UsageFault unfit) {
            throw new IllegalArgumentException(unfit.getMessage(), unfit);
        }
        Path folder = data == null ? DataDirectory.ofUser() : data;
        DataDirectory opened = remote.isGiven()
                ? DataDirectory.openForSessionElsewhere(folder)
                : options.replay().isPresent() ? DataDirectory.openForReplay(folder) : DataDirectory.open(folder);
        opening.open(options, opened);
    }

    private StartOptions options() throws IOException {
        List<BoatAddress> addresses = new ArrayList<>();
        for (String text : connect) {
            try {
                addresses.addAll(BoatAddress.parseAll(text));
            } catch (IllegalArgumentException unfit) {
                throw new IllegalArgumentException("--connect: " + unfit.getMessage(), unfit);
            }
        }
        if (boatsFile != null) {
            addresses.addAll(addressesIn(boatsFile));
        }
        return new StartOptions(
                addresses,
                Optional.ofNullable(project),
                look.theme(),
                look.scale(),
                Optional.ofNullable(resume),
                Optional.ofNullable(replay),
                Optional.ofNullable(at).map(seconds -> Math.round(seconds * 1000)),
                Optional.ofNullable(conditions),
                new StartOptions.Near(near, network.address()),
                domain.equals(StartOptions.BOATS) ? domain : shipped(),
                vessels(),
                layers(),
                lostLink.wish(),
                Optional.of(remote).filter(RemoteOptions::isGiven));
    }

    private ForeignVessels vessels() {
        try {
            return vessels == null ? ForeignVessels.NONE : VesselsFile.read(vessels, "--vessels");
        } catch (UsageFault e) {
            throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
        }
    }

    private WaterLayers layers() {
        try {
            return layers.layers(Path.of(""));
        } catch (UsageFault e) {
            throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
        }
    }

    private String shipped() {
        if (!domain.matches("[a-z][a-z0-9-]*")
                || OperatorCommand.class.getResource("/org/sami/domain/" + domain + "/domain.json") == null
                || !isHandled(domain)) {
            throw new ParameterException(
                    spec.commandLine(), "--domain: '" + domain + "' does not come with this program; uav and team do");
        }
        return domain;
    }

    private static boolean isHandled(String shipped) {
        return DomainLibrary.fromClassPath("/org/sami/domain/" + shipped)
                .result()
                .filter(library -> HandlerModules.isHandled(library.vocabulary()))
                .isPresent();
    }

    private static List<BoatAddress> addressesIn(Path file) throws IOException {
        List<String> lines;
        try {
            lines = BoundedFile.text(file, BoundedFile.SETTINGS_BYTES).lines().toList();
        } catch (NoSuchFileException missing) {
            throw new IOException("--boats: there is no file " + file);
        } catch (FileTooLargeException large) {
            throw new IOException("--boats: " + large.getMessage());
        } catch (IOException fault) {
            throw new IOException("--boats: " + file + " cannot be read: " + fault.getMessage());
        }
        List<BoatAddress> addresses = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            String text = lines.get(i).replaceAll("#.*", "").strip();
            try {
                if (!text.isEmpty()) {
                    addresses.addAll(BoatAddress.parseAll(text));
                }
            } catch (IllegalArgumentException unfit) {
                throw new IOException("--boats: " + file + " line " + (i + 1) + ": " + unfit.getMessage());
            }
        }
        return addresses;
    }
}
