package org.sami.crw.sim.run.operator;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.motion.WithoutComingHome;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.session.Scheduler;
import org.sami.crw.sim.run.operator.InterruptPress.State;
import org.sami.crw.sim.run.settings.PlannedInterrupt;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.Reserved;

/**
 * Presses a run's interrupts (thesis 7.0.2, 7.1.1): at their times, counted from the start of the first mission, or when a boat's battery turns
 * critical. A press that no transition takes is repeated until one does or all missions have ended, at most once a second, and only after something
 * has happened in a mission; until then the answer would be the same.
 *
 * <p>It needs a host and a clock. The host's listeners and the clock's actions run on one thread.
 */
public final class InterruptScheduler implements HostListener {
    private static final long AGAIN_MILLIS = 1000;
    private static final Set<String> BATTERY_NEWS =
            Set.of(EventNames.BATTERY_NOMINAL, EventNames.BATTERY_LOW, EventNames.BATTERY_CRITICAL);

    private final List<PlannedInterrupt> planned;
    private final Scheduler clock;
    private final List<InterruptPress> presses = new ArrayList<>();
    private final Set<String> critical = new LinkedHashSet<>();
    private final Set<String> excused = new HashSet<>(); // they go on with a critical battery
    private Consumer<Input> door =
            input -> {}; // does nothing while the past of a run is repeated: the presses are in it
    private final Set<Long> missions = new HashSet<>(); // running root missions
    private boolean begun;
    private boolean over;

    /** A scheduler for these interrupts. */
    public InterruptScheduler(List<PlannedInterrupt> planned, Scheduler clock) {
        this.planned = List.copyOf(planned);
        this.clock = clock;
        for (PlannedInterrupt plan : planned) {
            if (!plan.isForBattery()) {
                presses.add(new InterruptPress(plan, plan.boat().stream().toList()));
            }
        }
    }

    /**
     * Connects it to a host: before the mission starts, or after the past of the run has been repeated. Presses that are missing there are made now.
     */
    public void connect(EngineHost pressed) {
        door = pressed::post;
        for (InterruptPress press : presses) {
            if (press.state == State.POSTED) {
                press.state = State.DUE_AGAIN;
                clock.after(0, () -> press(press));
            }
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        List<InterruptPress> refused =
                presses.stream().filter(p -> p.state == State.REFUSED).toList();
        judge(atMillis, input, effects);
        if (input instanceof Input.Received received) {
            battery(received.occurrence());
        }
        WithoutComingHome.of(input).ifPresent(this::excuse);
        boolean changed = false;
        for (Effect effect : effects) {
            changed |= effect instanceof Effect.Fired || effect instanceof Effect.Activated;
            if (effect instanceof Effect.MissionStarted started && started.parent() == Ids.NONE) {
                started(started.mission());
            } else if (effect instanceof Effect.MissionEnded ended && missions.remove(ended.mission())) {
                over = missions.isEmpty();
            }
        }
        if (changed) {
            refused.forEach(this::again);
        }
    }

    private void started(long mission) {
        missions.add(mission);
        over = false;
        if (!begun) {
            begun = true;
            begin();
        }
    }

    private void begin() {
        for (InterruptPress press : presses) {
            clock.after(press.plan.afterMillis().orElse(0), () -> press(press));
        }
        critical.forEach(this::turnedCritical);
    }

    private void again(InterruptPress press) {
        if (press.state == State.REFUSED) {
            press.state = State.DUE_AGAIN;
            clock.after(Math.max(0, press.lastMillis() + AGAIN_MILLIS - clock.nowMs()), () -> press(press));
        }
    }

    private void press(InterruptPress press) {
        if (!over && (press.state == State.AHEAD || press.state == State.DUE_AGAIN)) {
            press.state = State.POSTED;
            door.accept(press.input());
        }
    }

    /** Records the results of presses: of one that this step took in, and of those whose boats were chosen. */
    private void judge(long atMillis, Input input, List<Effect> effects) {
        if (input instanceof Input.Interrupt) {
            presses.stream()
                    .filter(p -> p.state == State.POSTED && p.input().equals(input))
                    .findFirst()
                    .ifPresent(press -> {
                        press.pressed(atMillis);
                        judge(press, atMillis, effects);
                    });
            return;
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionClosed closed) {
                presses.stream()
                        .filter(p -> p.state == State.ASKED && p.decision == closed.decision())
                        .forEach(press -> answered(press, atMillis, closed, effects));
            }
        }
    }

    private static void answered(
            InterruptPress press, long atMillis, Effect.DecisionClosed closed, List<Effect> effects) {
        if (closed.answer().orElse(null) instanceof Answer.Proxies chosen) {
            press.chosen(chosen.proxies());
        }
        judge(press, atMillis, effects);
    }

    private static void judge(InterruptPress press, long atMillis, List<Effect> effects) {
        String name = press.plan.name();
        press.state = State.REFUSED;
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired fired && fired.used().stream().anyMatch(o -> isPress(o, name))) {
                press.taken(atMillis);
                return;
            }
            if (effect instanceof Effect.DecisionOpened opened
                    && opened.decision().type().equals(Decision.INTERRUPT + name)) {
                press.state = State.ASKED;
                press.decision = opened.decision().id();
            }
        }
    }

    private static boolean isPress(Occurrence used, String name) {
        return new TextValue(name).equals(used.values().get(Reserved.INTERRUPT_NAME));
    }

    private void battery(Occurrence news) {
        if (!BATTERY_NEWS.contains(news.type())) {
            return;
        }
        for (String boat : news.proxies()) {
            if (!news.type().equals(EventNames.BATTERY_CRITICAL)) {
                critical.remove(boat);
                presses.stream()
                        .filter(p -> p.plan.isForBattery() && p.isWaitingFor(boat))
                        .forEach(p -> p.state = State.GIVEN_UP);
            } else if (critical.add(boat) && begun) {
                turnedCritical(boat);
            }
        }
    }

    /** Boats that the operator has sent on with a critical battery are not pulled out until they have visited one point more. */
    private void excuse(WithoutComingHome news) {
        if (news.goes()) {
            excused.add(news.boat());
        } else if (excused.remove(news.boat()) && critical.contains(news.boat()) && begun) {
            turnedCritical(news.boat());
        }
    }

    private void turnedCritical(String boat) {
        if (excused.contains(boat)) {
            return;
        }
        for (PlannedInterrupt plan : planned) {
            if (plan.isForBattery() && plan.boat().map(boat::equals).orElse(true)) {
                InterruptPress press = new InterruptPress(plan, List.of(boat));
                presses.add(press);
                clock.after(0, () -> press(press));
            }
        }
    }

    /** Whether a press is due in the future at a fixed time. */
    public boolean hasPlans() {
        return !over && presses.stream().anyMatch(p -> p.state == State.AHEAD);
    }

    /** Whether it presses as soon as another boat's battery turns critical. */
    public boolean waitForBatteries() {
        return !over && planned.stream().anyMatch(PlannedInterrupt::isForBattery);
    }

    /** The result of each press, in the order of planning, then in the order in which boats turned critical. */
    public List<InterruptResult> results() {
        return presses.stream().map(InterruptPress::result).toList();
    }
}
