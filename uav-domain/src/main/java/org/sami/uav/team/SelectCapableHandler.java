package org.sami.uav.team;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.planning.BoatDemands;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * Select Capable: answers which of the entering robots have all that the field {@code needs} names, and measure the channel of
 * {@code measures}, as {@link BoatDemands#offers} says; of all of the
 * mission where none entered. Where none has it, the answer and a message to the operator say what each lacks.
 */
final class SelectCapableHandler implements ActivationHandler {
    static final String TYPE = "SelectCapable";

    private static final String NEEDS = "needs";
    private static final String MEASURES = "measures";
    private static final String SELECTED = "CapableSelected";
    private static final String NONE = "NoneCapable";

    private final ProxyRegistry robots;
    private final MessageSink messages;

    SelectCapableHandler(ProxyRegistry robots, MessageSink messages) {
        this.robots = robots;
        this.messages = messages;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        Set<String> needs = needs(ActivationFields.required(activation, NEEDS));
        activation
                .value(MEASURES)
                .filter(TextValue.class::isInstance)
                .map(channel -> ((TextValue) channel).value().strip())
                .filter(channel -> !channel.isEmpty())
                .ifPresent(needs::add);
        List<String> capable = new ArrayList<>();
        List<String> reasons = new ArrayList<>();
        for (String robot : asked(activation, context)) {
            Optional<String> lacks = lacks(robot, needs);
            if (lacks.isPresent()) {
                reasons.add(robot + " " + lacks.get());
            } else {
                capable.add(robot);
            }
        }
        if (capable.isEmpty()) {
            String reason = "No robot has " + String.join(" and ", needs)
                    + (reasons.isEmpty() ? ": none is in the mission" : ": " + String.join("; ", reasons));
            messages.tell(ActivationMessages.of(activation, context, Priority.HIGH, reason, List.of()));
            answer(activation, context, NONE, capable, Map.of("reason", new TextValue(reason)));
        } else {
            answer(activation, context, SELECTED, capable, Map.of());
        }
    }

    private static void answer(
            Activation activation, HandlerContext context, String type, List<String> names, Map<String, Value> values) {
        context.post(new Input.Received(Occurrence.answer(type, activation, names, List.of(), values)));
    }

    private static Set<String> needs(Value value) {
        Set<String> needs = new TreeSet<>();
        if (value instanceof ListValue list) {
            list.items().stream()
                    .filter(TextValue.class::isInstance)
                    .forEach(item -> needs.add(((TextValue) item).value()));
        }
        return needs;
    }

    private static Set<String> asked(Activation activation, HandlerContext context) {
        Set<String> asked = new LinkedHashSet<>();
        Addressee.of(activation, context).forEach(addressee -> asked.add(addressee.boat()));
        return asked.isEmpty() ? context.query(view -> ofMission(activation.mission(), view)) : asked;
    }

    private static Set<String> ofMission(long mission, EngineView view) {
        Set<String> names = new LinkedHashSet<>();
        view.mission(mission)
                .ifPresent(one -> one.marking()
                        .values()
                        .forEach(tokens -> tokens.forEach(token -> {
                            if (token instanceof Token.Proxy proxy) {
                                names.add(proxy.proxy());
                            }
                        })));
        return names;
    }

    /** What a robot lacks, in words; empty where it has all. */
    private Optional<String> lacks(String name, Set<String> needs) {
        Optional<BoatProxy> robot = robots.find(name);
        if (robot.flatMap(one -> one.status().pose()).isEmpty()) {
            return Optional.of("has not said yet where it is");
        }
        boolean flies = robot.get().isFlying();
        Set<String> offers = BoatDemands.offers(Set.of(), robot.get().capabilities(), flies);
        Set<String> missing = new TreeSet<>(needs);
        missing.removeAll(offers);
        if (missing.isEmpty()) {
            return Optional.empty();
        } else if (missing.contains(BoatDemands.FLIGHT)) {
            return Optional.of("does not fly");
        } else if (missing.contains(BoatDemands.WATER)) {
            return Optional.of("flies");
        }
        return Optional.of("has no " + String.join(" and no ", missing));
    }
}
