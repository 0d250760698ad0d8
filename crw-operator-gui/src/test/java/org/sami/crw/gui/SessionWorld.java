package org.sami.crw.gui;

import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.Component;
import java.awt.Container;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.text.JTextComponent;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.gui.context.BoatSelection;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.value.SessionEditors;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.palette.ProxyMarks;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.EventThread;
import org.sami.ui.check.Layout;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.value.MapMaker;
import org.sami.ui.value.ValueEditors;
import org.sami.ui.window.Notices;

/** A session with simulated boats behind loopback sockets, and panels over it that need no display: for tests only. */
public final class SessionWorld implements AutoCloseable {
    public static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    /** Where boats lie. */
    public static final GeoPoint PIER = GeoPoint.of(45.4, 10.9);

    public final Session session;
    public final OperatorContext context;
    private final SimulatedBoatsOnTcp simulated = new SimulatedBoatsOnTcp(1);

    /** Opens the session, and waits until its boats have joined. */
    public SessionWorld(Project project, String... boats) throws Exception {
        SessionRuntime runtime = SessionRuntime.RealTime.named(
                        SessionRuntime.RealTime.newClientId(), new SteadyClock(ProcessClock::ms))
                .withFront(EventThread.executor())
                .withSimulatedBoats(simulated);
        session = Session.open(SessionSetup.of(LIBRARY.vocabulary(), project).with(runtime));
        context = new OperatorContext(
                session, new CommandRegistry(), new ProxyMarks(), new BoatSelection(), new Notices());
        session.begin();
        for (String boat : boats) {
            add(boat, PIER);
        }
    }

    /** Adds a boat that lies somewhere, and waits until it has joined. */
    public void add(String boat, GeoPoint at) throws Exception {
        get(session.fleet().connect(simulated.launch(boat, at)));
        Await.until(
                boat + " has joined",
                () -> session.ask(view -> view.proxies().contains(boat))
                        .toCompletableFuture()
                        .join());
    }

    /** A project, as a plan file has it. */
    public static Project project(String json) {
        return new ProjectReader(LIBRARY.vocabulary())
                .readAndCheck(json.replace('\'', '"'))
                .orThrow();
    }

    /** The project of a plan of the library. */
    public static Project library(String plan) {
        return LIBRARY.projectOf(plan).orElseThrow();
    }

    /** Starts a mission of a plan. */
    public long start(String plan) throws Exception {
        return get(session.start(plan, plan, Map.of()));
    }

    /** What comes of something that the session was asked. */
    public static <T> T get(CompletionStage<T> stage) throws Exception {
        return stage.toCompletableFuture().get(300, TimeUnit.SECONDS);
    }

    /** Editors of values, with plain maps. */
    public ValueEditors editors() {
        return SessionEditors.of(
                context,
                new ComponentChoice(LIBRARY.components(), LIBRARY.vocabulary().types()),
                MapMaker.PLAIN);
    }

    /** Makes a panel, lays it out and gives it. */
    public static <T extends Container> T laidOut(Supplier<T> made) {
        return onEventThread(() -> {
            T panel = made.get();
            Layout.layOut(panel, 800, 500);
            return panel;
        });
    }

    /** Waits until something is so on the event thread. */
    public static void until(String what, BooleanSupplier condition) {
        Await.until(what, () -> onEventThread(condition::getAsBoolean));
    }

    /** The component of a name. */
    public static <T extends Component> T find(Container root, String name, Class<T> type) {
        return onEventThread(
                () -> Layout.find(root, name, type).orElseThrow(() -> new AssertionError("there is no " + name)));
    }

    /** What stands in a component. */
    public static String text(Container root, String name) {
        Component component = find(root, name, Component.class);
        return onEventThread(() -> component instanceof JTextComponent text
                ? text.getText()
                : component instanceof JLabel label ? label.getText() : ((AbstractButton) component).getText());
    }

    /** What stands in a table, a row a line, cells divided by bars. */
    public static String rows(Container root, String name) {
        JTable table = find(root, name, JTable.class);
        return onEventThread(() -> {
            StringBuilder all = new StringBuilder();
            for (int row = 0; row < table.getRowCount(); row++) {
                for (int column = 0; column < table.getColumnCount(); column++) {
                    all.append(column == 0 ? "" : "|").append(table.getValueAt(row, column));
                }
                all.append('\n');
            }
            return all.toString();
        });
    }

    /** Selects a row of a table. */
    public static void select(Container root, String name, int row) {
        JTable table = find(root, name, JTable.class);
        onEventThread(() -> {
            table.setRowSelectionInterval(row, row);
            return null;
        });
    }

    /** Types a text into a field. */
    public static void type(Container root, String name, String text) {
        JTextComponent field = find(root, name, JTextComponent.class);
        onEventThread(() -> {
            field.setText(text);
            return null;
        });
    }

    /** Presses a button that can be pressed. */
    public static void press(Container root, String name) {
        until(
                name + " can be pressed",
                () -> find(root, name, AbstractButton.class).isEnabled());
        onEventThread(() -> {
            find(root, name, AbstractButton.class).doClick(0);
            return null;
        });
    }

    /** Runs a command that can be run. */
    public void run(String command) {
        until(
                command + " can be run",
                () -> context.commands().get(command).whyNot().isEmpty());
        onEventThread(() -> {
            context.commands().get(command).run();
            return null;
        });
    }

    /** Why a command cannot be run now; empty text where it can. */
    public String whyNot(String command) {
        return onEventThread(() -> context.commands().get(command).whyNot().orElse(""));
    }

    @Override
    public void close() throws Exception {
        session.close();
    }
}
