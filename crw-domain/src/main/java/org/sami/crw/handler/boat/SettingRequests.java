package org.sami.crw.handler.boat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.CommandMemory;
import org.sami.crw.handler.activation.OptionalAnswer;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * Settings that activations ask of boats, and one answer about each boat: it has taken over all of them, or not, and why. While a
 * link is lost they wait. What was answered is not set again by a base that goes on with the mission, as the operator may have set something else since
 * (decision 0731). For the fleet's thread.
 */
public final class SettingRequests implements Consumer<FleetEvent> {
    private final ProxyRegistry boats;
    private final MessageSink messages;
    private final Map<Command, Asked> asked = new LinkedHashMap<>();

    public SettingRequests(ProxyRegistry boats, MessageSink messages) {
        this.boats = boats;
        this.messages = messages;
    }

    /** Which input events answer. */
    record Answers(String succeeded, String failed) {}

    /**
     * Asks every boat that an activation speaks to, but for those that have still to answer it.
     *
     * @param settings sets what is to be set on a boat and names the commands; an {@link IllegalArgumentException} is the reason why
     *     it cannot be set
     */
    void ask(
            Activation activation, HandlerContext context, Answers answers, Function<BoatProxy, Set<String>> settings) {
        for (Addressee addressee : Addressee.of(activation, context)) {
            Asked one = new Asked(activation, context, addressee, answers, new HashSet<>());
            if (asked.values().stream().anyMatch(one::isAskedBy) || one.isOver()) {
                continue;
            }
            one.rememberOrder();
            Optional<BoatProxy> boat = boats.find(addressee.boat());
            if (boat.isEmpty()) {
                fail(one, MotionCommands.UNKNOWN_BOAT);
                continue;
            }
            try {
                one.waiting.addAll(settings.apply(boat.get()));
                one.waiting.forEach(command -> asked.put(new Command(addressee.boat(), command), one));
            } catch (IllegalArgumentException e) {
                fail(one, String.valueOf(e.getMessage()));
            }
        }
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.SettingTaken set) {
            onTuningTaken(set.boat(), set.commandId());
        } else if (event instanceof FleetEvent.SettingRefused refused) {
            onTuningRefused(refused.boat(), refused.commandId(), refused.reason());
        }
    }

    private void onTuningTaken(String boatId, String commandId) {
        Asked one = asked.remove(new Command(boatId, commandId));
        if (one != null && one.waiting.remove(commandId) && one.waiting.isEmpty()) {
            one.post(
                    CommandMemory.COMPLETED.remember(one.mission(), one.id(), one.context),
                    one.answers.succeeded,
                    Map.of());
        }
    }

    private void onTuningRefused(String boatId, String commandId, String reason) {
        Asked one = asked.remove(new Command(boatId, commandId));
        if (one != null) {
            one.waiting.forEach(other -> asked.remove(new Command(boatId, other)));
            fail(one, reason);
        }
    }

    private void fail(Asked one, String reason) {
        String boat = one.addressee.boat();
        messages.tell(ActivationMessages.of(
                one.activation,
                one.context,
                Priority.HIGH,
                boat + " has not taken over what \"" + one.activation.place() + "\" set: " + reason,
                List.of(boat)));
        one.post(
                CommandMemory.failed(one.mission(), one.id(), reason, one.context),
                one.answers.failed,
                Map.of("reason", new TextValue(reason)));
    }

    /** A command; its id is unique on its boat alone. */
    private record Command(String boat, String id) {}

    /** What one activation asked of one boat, and the commands that it has not answered yet. */
    private record Asked(
            Activation activation, HandlerContext context, Addressee addressee, Answers answers, Set<String> waiting) {

        long mission() {
            return activation.mission();
        }

        /** Under which the mission remembers it. */
        String id() {
            return CommandMemory.id(activation, addressee.boat());
        }

        boolean isAskedBy(Asked other) {
            return other.id().equals(id());
        }

        /** Whether it had its answer before a restart of the base. */
        boolean isOver() {
            return CommandMemory.isOver(activation, id(), context);
        }

        void rememberOrder() {
            post(CommandMemory.ordered(activation, id(), context));
        }

        /** What the mission remembers is in one batch with the answer, which may end it. */
        void post(List<Input> memory, String event, Map<String, Value> values) {
            List<Input> inputs = new ArrayList<>(memory);
            inputs.addAll(OptionalAnswer.of(addressee.answer(event, activation, values), context));
            post(inputs);
        }

        private void post(List<Input> inputs) {
            if (!inputs.isEmpty()) {
                context.post(inputs);
            }
        }
    }
}
