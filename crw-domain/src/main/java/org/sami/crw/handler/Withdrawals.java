package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.planning.Computations;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/**
 * Passes withdrawals on to the boats, in the order of a step's effects. The host calls listeners before the step's handlers, on
 * the same executor as far as the fleet is concerned; so what the step asked before it withdrew is taken back in advance,
 * and what it asks afterwards stands.
 */
final class Withdrawals implements HostListener {
    private final Set<String> commands;
    private final MotionCommands motion;
    private final Computations computations;
    private final Executor fleet;

    /** Watches for withdrawals of what output events of certain types have asked. */
    Withdrawals(Set<String> commands, MotionCommands motion, Computations computations, Executor fleet) {
        this.commands = Set.copyOf(commands);
        this.motion = motion;
        this.computations = computations;
        this.fleet = fleet;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        List<Activation> asked = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated activated
                    && commands.contains(activated.activation().type())) {
                asked.add(activated.activation());
            } else if (effect instanceof Effect.CommandsWithdrawn withdrawn) {
                List<Activation> before = asked.stream()
                        .filter(activation -> activation.mission() == withdrawn.mission())
                        .toList();
                fleet.execute(() -> withdraw(withdrawn, before));
            }
        }
    }

    private void withdraw(Effect.CommandsWithdrawn withdrawn, List<Activation> askedBefore) {
        motion.withdraw(withdrawn.mission(), withdrawn.proxies());
        computations.withdraw(withdrawn.mission(), withdrawn.proxies(), Optional.empty(), motion);
        for (Activation activation : askedBefore) {
            motion.takeBack(
                    activation.id(),
                    withdrawn.proxies().isEmpty() ? activation.proxies() : withdrawn.proxies(),
                    Optional.empty());
        }
    }
}
