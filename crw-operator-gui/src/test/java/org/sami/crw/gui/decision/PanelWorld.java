package org.sami.crw.gui.decision;

import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.Component;
import java.awt.Container;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import javax.swing.AbstractButton;
import javax.swing.text.JTextComponent;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.SlowableClock;
import org.sami.crw.gui.context.BoatSelection;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.palette.ProxyMarks;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.EventThread;
import org.sami.ui.check.Layout;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.value.MapMaker;
import org.sami.ui.window.Notices;

/** A session with simulated boats behind loopback sockets, and the panel of its decisions, which is acted on on the event thread. */
final class PanelWorld implements AutoCloseable {
    private static final GeoPoint PIER = GeoPoint.of(45.4, 10.9);
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    final Session session;
    final OperatorContext context;
    final DecisionsPanel panel;
    final PenMap map = new PenMap();
    final SlowableClock clock = new SlowableClock();
    volatile LongSupplier wallMillis = System::currentTimeMillis;

    PanelWorld(String plan, String... boats) throws Exception {
        SimulatedBoatsOnTcp simulated = new SimulatedBoatsOnTcp(1);
        SessionRuntime runtime = SessionRuntime.RealTime.named(
                        SessionRuntime.RealTime.newClientId(), new SteadyClock(clock))
                .withFront(EventThread.executor())
                .withSimulatedBoats(simulated);
        session = Session.open(
                SessionSetup.of(LIBRARY.vocabulary(), LIBRARY.projectOf(plan).orElseThrow())
                        .with(runtime));
        context = new OperatorContext(
                session, new CommandRegistry(), new ProxyMarks(), new BoatSelection(), new Notices());
        panel = onEventThread(() -> SessionDecisions.panel(
                context,
                LIBRARY.components(),
                map,
                MapMaker.PLAIN,
                new ShownPictures(context),
                () -> wallMillis.getAsLong()));
        session.begin();
        for (String boat : boats) {
            session.fleet()
                    .connect(simulated.launch(boat, PIER))
                    .toCompletableFuture()
                    .get(300, TimeUnit.SECONDS);
            Await.until(
                    boat + " has joined",
                    () -> session.ask(view -> view.proxies().contains(boat))
                            .toCompletableFuture()
                            .join());
        }
        session.start(plan, plan, java.util.Map.of()).toCompletableFuture().get(300, TimeUnit.SECONDS);
    }

    void until(String what, BooleanSupplier condition) {
        try {
            Await.until(what, () -> onEventThread(condition::getAsBoolean));
        } catch (AssertionError late) {
            throw new AssertionError(late.getMessage() + "; shown is: " + texts(panel), late);
        }
    }

    private static String texts(Container root) {
        StringBuilder all = new StringBuilder();
        for (Component child : root.getComponents()) {
            if (child.getName() != null) {
                all.append(child.getName()).append(' ');
            }
            if (child instanceof Container inner) {
                all.append(texts(inner));
            }
        }
        return all.toString();
    }

    <T extends Component> Optional<T> find(String name, Class<T> type) {
        return onEventThread(() -> Layout.find(panel, name, type)).filter(one -> isSeen(one));
    }

    private boolean isSeen(Component component) {
        for (Container parent = component.getParent(); parent != panel; parent = parent.getParent()) {
            if (parent == null || !parent.isVisible()) {
                return false;
            }
        }
        return component.isVisible();
    }

    void press(String name) {
        until(
                name + " can be pressed",
                () -> Layout.find(panel, name, AbstractButton.class)
                        .filter(Component::isEnabled)
                        .isPresent());
        onEventThread(() -> {
            Layout.find(panel, name, AbstractButton.class).orElseThrow().doClick(0);
            return null;
        });
    }

    void type(String name, String text) {
        until(
                name + " can be typed into",
                () -> Layout.find(panel, name, JTextComponent.class).isPresent());
        onEventThread(() -> {
            Layout.find(panel, name, JTextComponent.class).orElseThrow().setText(text);
            return null;
        });
    }

    /** Presses a key of the panel, as its map of keys has it. */
    void key(String action) {
        onEventThread(() -> {
            panel.getActionMap().get(action).actionPerformed(null);
            return null;
        });
    }

    String text(String name) {
        return onEventThread(() -> {
            Component component = Layout.find(panel, name, Component.class).orElseThrow();
            return component instanceof JTextComponent text
                    ? text.getText()
                    : ((javax.swing.JLabel) component).getText();
        });
    }

    boolean enabled(String name) {
        return onEventThread(() ->
                Layout.find(panel, name, AbstractButton.class).orElseThrow().isEnabled());
    }

    @Override
    public void close() throws java.io.IOException {
        session.close();
    }
}
