package org.sami.crw.gui.window;

import java.awt.BorderLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.Timer;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.BoatSelection;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.sound.AlarmSounds;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.status.FaultCommands;
import org.sami.crw.gui.status.FleetStopCommands;
import org.sami.crw.gui.status.HealthRow;
import org.sami.crw.gui.status.StatusStrip;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.near.BoatFinder;
import org.sami.crw.session.BoatsAtEnd;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.palette.ProxyMarks;
import org.sami.spn.protocol.Priority;
import org.sami.ui.command.CommandKeys;
import org.sami.ui.command.CommandPolicy;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockArea;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;
import org.sami.ui.window.FrameSize;
import org.sami.ui.window.Notices;
import org.sami.ui.window.WindowSettings;

/** The operator's window over a session. On the event thread. */
public final class OperatorWindow {
    private static final String TITLE = "SAMI operator";
    private static final int BROKEN = 4;
    private static final int REFRESH_MS = 250;

    private final Session session;
    private final DataDirectory data;
    private final OperatorContext context;
    private final IntConsumer ended;
    private final JFrame frame = new JFrame(TITLE);
    private final DockArea dock;
    private final OperatorPanels panels;
    private final WindowCommands commands;
    private final CommandKeys keys;
    private final AlarmSounds sounds;
    private final Timer refresh;

    /**
     * A window that is not shown yet.
     *
     * @param project file of the project with which the session began; empty = it came with the program
     * @param data is closed with the window, as the session is
     * @param ended is called when all is closed: 0, or 4 where something could not be, the session had broken or missions stood still for its journal
     */
    public OperatorWindow(
            Session session, Optional<Path> project, DataDirectory data, WindowSettings settings, IntConsumer ended) {
        this.ended = ended;
        this.session = session;
        this.data = data;
        RobotKind robots = HandlerModules.robotsOf(session.setup().vocabulary());
        context = new OperatorContext(
                session,
                new CommandRegistry(CommandPolicy.ALL, robots::say),
                new ProxyMarks(),
                new BoatSelection(),
                new Notices(robots::say));
        FleetStopCommands fleetStop = new FleetStopCommands(context);
        new FaultCommands(context, settings);
        LoadedProject file = new LoadedProject(project);
        panels = new OperatorPanels(context, settings, file);
        sounds = AlarmSounds.of(context, settings);
        dock = new DockArea(frame, panels.all(), panels.offered(), data.arrangement());
        commands = new WindowCommands(context, frame, settings, loaded -> {
            file.set(loaded);
            panels.reloadPlans();
        });
        commands.addPanels(dock, panels);
        commands.addReplay(data.folder());
        commands.addEnd(this::askToEnd);
        StatusStrip strip = new StatusStrip(
                context,
                fleetStop,
                context.commands().get("panel-alarms"),
                context.commands().get("panel-decisions"),
                panels::decisionUnseen);
        frame.setName("operator-window");
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.setJMenuBar(new WindowMenus(context.commands(), panels.all(), robots).bar());
        JPanel top = new JPanel(new BorderLayout());
        top.add(strip);
        top.add(new HealthRow(context, context.commands().get("panel-health")), BorderLayout.SOUTH);
        frame.getContentPane().add(top, BorderLayout.NORTH);
        frame.getContentPane().add(dock);
        WindowSheet.in(frame.getRootPane()).keepFree(top);
        keys = CommandKeys.install(context.commands(), context.notices()::refused);
        refresh = new Timer(REFRESH_MS, e -> {
            strip.refresh();
            panels.refresh();
            dock.shareRoom();
        });
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                askToEnd();
            }
        });
    }

    /** Shows it, as large as the screen allows. */
    public void open() {
        FrameSize.show(frame);
        dock.arrange();
        dock.trouble().ifPresent(this::reportArrangement);
        panels.focusFirst();
        refresh.start();
    }

    private void reportArrangement(String trouble) {
        session.models()
                .health()
                .report(HealthFault.of(
                                HealthKind.FILE,
                                data.arrangement().getFileName().toString(),
                                Priority.LOW,
                                "The file of the arrangement of panels is damaged",
                                "The panels lie as at first; arrange them again")
                        .withDetails(trouble));
    }

    /** Says in the title what conditions were named for the session. */
    public void showConditions(NamedConditions named) {
        frame.setTitle(TITLE + " – conditions: " + named);
    }

    /** Says where boats near are looked for; else on all networks of this machine. */
    public void lookForBoats(Supplier<BoatFinder> where) {
        commands.lookForBoats(where);
    }

    /** Says which simulated boats can be shown to ground stations. */
    public void showToGroundStations(SimulatedBoatsOnTcp boats) {
        commands.showToGroundStations(boats);
    }

    /** The frame, for those who drive it. */
    public JFrame frame() {
        return frame;
    }

    /** Its commands, for those who drive it. */
    public CommandRegistry commands() {
        return context.commands();
    }

    /** The session that it shows. */
    public Session session() {
        return session;
    }

    /** Closes the window; asks in place first what boats shall do where missions run. */
    private void askToEnd() {
        if (!hasUnfinished()) {
            end();
            return;
        }
        WindowSheet sheet = WindowSheet.in(frame.getRootPane());
        sheet.open(new Sheet(
                "closing-sheet",
                "Close the window while missions run?",
                new ClosingForm(
                        context,
                        boats -> {
                            sheet.close();
                            end(boats);
                        },
                        sheet::close)));
    }

    private boolean hasUnfinished() {
        return !session.models().missions().snapshot().running().isEmpty();
    }

    /** Closes the window with boats stopped ({@link #end(BoatsAtEnd)}). */
    public void end() {
        end(BoatsAtEnd.STOP);
    }

    /**
     * Closes the window, and then, off the event thread, the session; the process ends with it.
     *
     * @param boats what the boats do then
     */
    public void end(BoatsAtEnd boats) {
        refresh.stop();
        keys.close();
        sounds.close();
        dock.close();
        commands.close();
        panels.close();
        frame.dispose();
        boolean failed = session.faults().failure().isPresent()
                || session.models().health().snapshot().missionsStandStill(); // waiting for its journal
        boolean unfinished = failed || hasUnfinished();
        new Thread(() -> leave(boats, unfinished, failed), "closing the session").start();
    }

    private void leave(BoatsAtEnd boats, boolean unfinished, boolean failed) {
        int code = failed ? BROKEN : 0;
        try {
            session.leave(boats).forEach(line -> System.err.println("crw-operator: " + line));
            session.close();
            if (!unfinished) {
                data.finished();
            }
            data.close();
        } catch (IOException fault) {
            System.err.println("crw-operator: " + fault.getMessage());
            code = BROKEN;
        } catch (RuntimeException | Error fault) {
            session.faults().guard().lost(Thread.currentThread().getName(), fault);
            code = BROKEN;
        }
        ended.accept(code);
    }
}
