package org.sami.crw.gui.window;

import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JOptionPane;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.start.WindowSettings;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandKeysPanel;
import org.sami.ui.command.CommandSearch;
import org.sami.ui.dock.DockArea;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;
import org.sami.ui.look.Theme;

/** The commands of the window itself: connect boats, open a project, themes and scale, panels, help, end. */
final class WindowCommands {
    private final OperatorContext context;
    private final JFrame frame;
    private final WindowSettings settings;
    private final Runnable projectLoaded;

    WindowCommands(OperatorContext context, JFrame frame, WindowSettings settings, Runnable projectLoaded) {
        this.projectLoaded = projectLoaded;
        this.context = context;
        this.frame = frame;
        this.settings = settings;
        add(new Command("boat-connect", "Connect a boat…", this::connect)
                .withKey("ctrl B")
                .withIcon("connect"));
        add(new Command("project-open", "Load a project…", this::load)
                .withKey("ctrl O")
                .withIcon("folder"));
        for (Theme theme : Theme.values()) {
            add(new Command("theme-" + theme.id(), "Theme: " + theme.title(), () -> look(theme, Look.scalePercent()))
                    .withIcon("theme"));
        }
        add(new Command("scale-larger", "Larger text", () -> look(Look.theme(), Look.nextScale(true)))
                .withKey("ctrl EQUALS")
                .withIcon("zoom-in"));
        add(new Command("scale-smaller", "Smaller text", () -> look(Look.theme(), Look.nextScale(false)))
                .withKey("ctrl MINUS")
                .withIcon("zoom-out"));
        add(new Command("scale-reset", "Text of 100 %", () -> look(Look.theme(), 100)).withKey("ctrl 0"));
        add(new Command("command-search", "Find a command…", () -> CommandSearch.open(frame, context.commands()))
                .withKey("ctrl shift P")
                .withIcon("search"));
        add(new Command("help-keys", "Commands and keys", () -> CommandKeysPanel.open(frame, context.commands()))
                .withKey("F1")
                .withIcon("keyboard"));
    }

    private void add(Command command) {
        context.commands().add(command);
    }

    private void look(Theme theme, int scale) {
        Look.apply(theme, scale);
        settings.keepLook();
    }

    /** A command for each panel, with Alt and a digit, and one that puts all back. */
    void addPanels(DockArea dock) {
        int digit = 1;
        for (DockPanel panel : dock.panels()) {
            String id = panel.getPersistentID();
            Command show = new Command("panel-" + id, "Show " + panel.title(), () -> dock.show(id));
            if (digit <= 9) {
                show.withKey("alt " + digit);
            }
            digit++;
            add(show);
        }
        add(new Command("panels-reset", "Put all panels back", dock::reset).withIcon("layout"));
    }

    /** The command that ends the program. */
    void addEnd(Runnable end) {
        add(new Command("end", "End the session and close", end)
                .withKey("ctrl Q")
                .withIcon("close"));
    }

    private void connect() {
        String text = JOptionPane.showInputDialog(
                frame, "Address of the boat's server, HOST:PORT", "Connect a boat", JOptionPane.PLAIN_MESSAGE);
        if (text != null && !text.isBlank()) {
            try {
                BoatAddress address = BoatAddress.parse(text.strip());
                context.notices().told("Connecting to " + address);
                context.session().fleet().connect(address).whenComplete((boat, fault) -> {
                    if (fault == null) {
                        context.notices().told(boat + " is connected");
                    } else {
                        context.notices().refused(address + ": " + fault.getMessage());
                    }
                });
            } catch (IllegalArgumentException unfit) {
                context.notices().refused(unfit.getMessage());
            }
        }
    }

    private void load() {
        JFileChooser chooser = new JFileChooser();
        chooser.setDialogTitle("Load a project; missions that run keep their plans");
        chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
            load(chooser.getSelectedFile().toPath());
        }
    }

    private void load(Path file) {
        Reading<Project> reading = new ProjectReader(context.vocabulary()).readAndCheck(file);
        Optional<Finding> wrong =
                reading.findings().stream().filter(Finding::isError).findFirst();
        if (wrong.isPresent() || reading.result().isEmpty()) {
            context.notices()
                    .refused(file.getFileName() + " is not loaded: "
                            + wrong.map(Finding::message).orElse("it cannot be read"));
            return;
        }
        context.tell(
                context.session().load(reading.result().get()).thenAccept(version -> projectLoaded.run()),
                file.getFileName() + " is loaded; missions that start now have its plans");
    }
}
