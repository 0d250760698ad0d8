package org.sami.crw.gui.remote;

import java.awt.BorderLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.util.Optional;
import java.util.function.IntConsumer;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.Timer;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.boat.ConnectSheet;
import org.sami.crw.gui.context.BoatSelection;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.crw.gui.context.MachineCommand;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.file.LogsSheet;
import org.sami.crw.gui.sound.AlarmSounds;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.status.FleetStopCommands;
import org.sami.crw.gui.status.HealthRow;
import org.sami.crw.gui.status.StatusStrip;
import org.sami.crw.gui.window.OperatorPanels;
import org.sami.crw.gui.window.ReplaySheet;
import org.sami.crw.gui.window.WindowMenus;
import org.sami.crw.handler.HandlerModules;
import org.sami.palette.ProxyMarks;
import org.sami.session.client.RemoteSession;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandKeys;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockArea;
import org.sami.ui.sheet.WindowSheet;
import org.sami.ui.window.FrameSize;
import org.sami.ui.window.Notices;
import org.sami.ui.window.ViewCommands;
import org.sami.ui.window.WindowSettings;

/**
 * The operator's window over a session in another process: the same panels, status strip and fleet stop, and a band that says whose session it is. What only the session's own
 * machine has, such as its keys, cannot be run and says why ({@link MachineCommand}). Closing it leaves the session as it is. On the event thread.
 */
public final class RemoteWindow {
    private static final int REFRESH_MS = 250;
    private static final int BROKEN = 4;

    private final RemoteSession session;
    private final DataDirectory data;
    private final IntConsumer ended;
    private final OperatorContext context;
    private final JFrame frame = new JFrame();
    private final LogsSheet logs;
    private final OperatorPanels panels;
    private final DockArea dock;
    private final CommandKeys keys;
    private final AlarmSounds sounds;
    private final Timer refresh;

    /**
     * A window that is not shown yet.
     *
     * @param band has listened to the session's connection from its beginning
     * @param data is closed with the window, as the connection is
     * @param ended is called when all is closed
     */
    public RemoteWindow(
            RemoteSession session,
            ConnectionBand band,
            DataDirectory data,
            WindowSettings settings,
            IntConsumer ended) {
        this.session = session;
        this.data = data;
        this.ended = ended;
        session.fetchPictures();
        RobotKind robots = HandlerModules.robotsOf(session.vocabulary());
        context = new OperatorContext(
                session,
                new CommandRegistry(new RightsPolicy(session::rights), robots::say),
                new ProxyMarks(),
                new BoatSelection(),
                new Notices(robots::say));
        CommandRegistry commands = context.commands();
        band.of(session.address().toString(), session.person(), context.notices(), commands::askPolicy, this::title);
        commands.add(ConnectSheet.command(context, frame.getRootPane()));
        for (MachineCommand machine : MachineCommand.values()) {
            if (machine.isFor(robots)) {
                commands.add(machine.elsewhere());
            }
        }
        logs = new LogsSheet(context, frame.getRootPane());
        commands.add(logs.command());
        commands.add(ReplaySheet.command(
                context, frame.getRootPane(), data.folder(), data.folder().resolveSibling("sessions")));
        FleetStopCommands fleetStop = new FleetStopCommands(context);
        panels = new OperatorPanels(context, settings, new LoadedProject(Optional.empty()));
        sounds = AlarmSounds.of(context, settings);
        dock = new DockArea(frame, panels.all(), panels.offered(), data.arrangement());
        ViewCommands view = new ViewCommands(commands, frame, settings);
        view.addPanels(dock);
        panels.addArrangements(dock, commands);
        commands.add(new Command("end", "Leave the session", this::end)
                .withKey("ctrl Q")
                .withIcon("close"));
        StatusStrip strip = new StatusStrip(
                context,
                fleetStop,
                commands.get("panel-alarms"),
                commands.get("panel-decisions"),
                panels::decisionUnseen);
        frame.setName("remote-window");
        title(session.address().toString());
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.setJMenuBar(new WindowMenus(commands, panels.all(), robots).bar());
        JPanel top = new JPanel(new BorderLayout());
        top.add(strip);
        JPanel lines = new JPanel(new BorderLayout());
        lines.add(band, BorderLayout.NORTH);
        lines.add(new HealthRow(context, commands.get("panel-health")));
        top.add(lines, BorderLayout.SOUTH);
        frame.getContentPane().add(top, BorderLayout.NORTH);
        frame.getContentPane().add(dock);
        WindowSheet.in(frame.getRootPane()).keepFree(top);
        keys = CommandKeys.install(commands, context.notices()::refused);
        refresh = new Timer(REFRESH_MS, e -> {
            strip.refresh();
            panels.refresh();
            dock.shareRoom();
        });
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                end();
            }
        });
    }

    private void title(String base) {
        frame.setTitle("SAMI operator – " + base + " – " + session.person());
    }

    /** Shows it, as large as the screen allows. */
    public void open() {
        FrameSize.show(frame);
        dock.arrange();
        panels.focusFirst();
        refresh.start();
    }

    /** The frame, for those who drive it. */
    public JFrame frame() {
        return frame;
    }

    /** Its commands, for those who drive it. */
    public CommandRegistry commands() {
        return context.commands();
    }

    /** Closes the window, and then, off the event thread, the connection. */
    public void end() {
        refresh.stop();
        keys.close();
        sounds.close();
        logs.end();
        dock.close();
        panels.close();
        frame.dispose();
        new Thread(this::leave, "leaving the session").start();
    }

    private void leave() {
        int code = 0;
        session.close();
        try {
            data.close();
        } catch (IOException fault) {
            System.err.println("crw-operator: " + fault.getMessage());
            code = BROKEN;
        }
        ended.accept(code);
    }
}
