package org.sami.crw.gui.window;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JFrame;
import org.sami.crw.gui.boat.ConnectSheet;
import org.sami.crw.gui.context.MachineCommand;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.file.LogsSheet;
import org.sami.crw.gui.key.KeysForm;
import org.sami.crw.gui.key.PairSheet;
import org.sami.crw.gui.near.NearSheet;
import org.sami.crw.gui.station.StationShow;
import org.sami.crw.proxy.near.BoatFinder;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.ui.command.Command;
import org.sami.ui.dock.DockArea;
import org.sami.ui.sheet.FileSheet;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;
import org.sami.ui.window.ViewCommands;
import org.sami.ui.window.WindowSettings;

/** The commands of the window itself: connect boats, open a project, themes and scale, panels, help, end. */
final class WindowCommands {
    private final OperatorContext context;
    private final JFrame frame;
    private final ViewCommands view;
    private final Consumer<Path> projectLoaded;
    private final NearSheet near;
    private final StationShow stations;
    private Supplier<BoatFinder> finder = BoatFinder::everywhere;

    WindowCommands(OperatorContext context, JFrame frame, WindowSettings settings, Consumer<Path> projectLoaded) {
        this.projectLoaded = projectLoaded;
        this.context = context;
        this.frame = frame;
        add(ConnectSheet.command(context, frame.getRootPane()));
        near = new NearSheet(context, frame.getRootPane(), () -> finder.get());
        add(MachineCommand.BOATS_NEAR.here(near::open));
        add(MachineCommand.PAIR.here(() -> new PairSheet(context, frame.getRootPane()).open()));
        if (MachineCommand.PHONE.isFor(context.robots())) {
            add(MachineCommand.PHONE.here(() -> new PairSheet(context, frame.getRootPane()).addPhone()));
        }
        add(MachineCommand.KEYS.here(this::keys));
        LogsSheet logs = new LogsSheet(context, frame.getRootPane());
        add(logs.command());
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent e) {
                logs.end();
            }
        });
        stations = new StationShow(context, frame.getRootPane());
        if (MachineCommand.GROUND_STATION.isFor(context.robots())) {
            add(MachineCommand.GROUND_STATION.here(stations::open).unless(stations::whyNot));
        }
        add(MachineCommand.PROJECT.here(this::load));
        view = new ViewCommands(context.commands(), frame, settings);
    }

    private void add(Command command) {
        context.commands().add(command);
    }

    void addPanels(DockArea dock, OperatorPanels panels) {
        view.addPanels(dock);
        panels.addArrangements(dock, context.commands());
    }

    /** The command that opens a journal in a window of its own. */
    void addReplay(Path folder) {
        add(ReplaySheet.command(context, frame.getRootPane(), folder, folder.resolve("sessions")));
    }

    /** The command that ends the program. */
    void addEnd(Runnable end) {
        add(new Command("end", "Close the window…", end).withKey("ctrl Q").withIcon("close"));
    }

    /** Says where the list of boats near looks for them; else on all networks. */
    void lookForBoats(Supplier<BoatFinder> where) {
        finder = where;
    }

    /** Says which simulated boats can be shown to ground stations. */
    void showToGroundStations(SimulatedBoatsOnTcp boats) {
        stations.of(boats);
    }

    /** Ends the work behind the panels. */
    void close() {
        near.close();
        stations.close();
    }

    private void keys() {
        PairSheet pairing = new PairSheet(context, frame.getRootPane());
        WindowSheet.in(frame.getRootPane())
                .open(new Sheet("keys-sheet", "Keys of this base", new KeysForm(context, pairing::open)));
    }

    private void load() {
        new FileSheet("project-file", "Load a project; missions that run keep their plans")
                .orFolder()
                .open(frame.getRootPane(), this::load);
    }

    private void load(Path file) {
        context.tell(
                context.here().project().load(file).thenAccept(version -> projectLoaded.accept(file)),
                file.getFileName() + " is loaded; missions that start now have its plans");
    }
}
