package org.sami.crw.judgement;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.crw.event.Numbers;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** What the fields of events of the boats domain can hold, as far as their types do not say it. */
final class FieldRules {
    private static final double FAR_M = 10_000;
    private static final double LEAST_SPACING_M = 0.1;

    private static final Map<String, Function<Value, Optional<String>>> RULES = Map.ofEntries(
            Map.entry(
                    "CreateSimulatedProxy.numberToCreate",
                    value -> number(value, 1, BoatConnector.MOST_CREATED, "simulated boats are added at once")),
            Map.entry("CreateSimulatedProxy.name", value -> text(value, "The boats need a name")),
            Map.entry("ConnectExistingProxy.name", value -> text(value, "The boat needs a name")),
            Map.entry("ConnectExistingProxy.server", FieldRules::address),
            Map.entry("TakeMeasurement.sensor", value -> text(value, "The sensor needs a name")),
            Map.entry(
                    "ProxyExploreArea.spacing", value -> number(value, LEAST_SPACING_M, FAR_M, "m lie between lanes")),
            Map.entry(
                    "DistributeLocationsRequest.spacing",
                    value -> number(value, LEAST_SPACING_M, FAR_M, "m lie between locations")),
            Map.entry(
                    "AssembleLocationRequest.spacing",
                    value -> number(value, LEAST_SPACING_M, FAR_M, "m lie between boats")),
            Map.entry("ProxyStationKeep.radius", value -> number(value, LEAST_SPACING_M, FAR_M, "m may a boat drift")),
            Map.entry(
                    "SetVelocityMultiplier.multiplier",
                    value -> number(value, 0, SetVelocityMultiplier.MAX_MULTIPLIER, "is the multiplier of speeds")),
            Map.entry("BatteryLevelSubscription.low", value -> number(value, 0, 100, "% is a level of charge")),
            Map.entry("BatteryLevelSubscription.critical", value -> number(value, 0, 100, "% is a level of charge")));

    private FieldRules() {}

    /** Why a value cannot be that of a field; empty where it can. */
    static Optional<String> wrong(String event, String field, Value value) {
        return Optional.ofNullable(RULES.get(event + "." + field)).flatMap(rule -> rule.apply(value));
    }

    private static Optional<String> text(Value value, String missing) {
        return value instanceof TextValue text && text.value().isBlank() ? Optional.of(missing) : Optional.empty();
    }

    private static Optional<String> address(Value value) {
        if (!(value instanceof TextValue text)) {
            return Optional.empty();
        }
        if (text.value().isBlank()) {
            return Optional.of("The address of the boat's server is empty: HOST:PORT, such as 192.168.1.101:11411");
        }
        try {
            BoatAddress.parse(text.value());
            return Optional.empty();
        } catch (IllegalArgumentException unfit) {
            return Optional.of(String.valueOf(unfit.getMessage()));
        }
    }

    private static Optional<String> number(Value value, double least, double most, String what) {
        if (!(value instanceof IntegerValue || value instanceof RealValue)) {
            return Optional.empty();
        }
        double number = Numbers.real(value);
        return number >= least && number <= most
                ? Optional.empty()
                : Optional.of(plain(least) + " to " + plain(most) + " " + what + ", not " + plain(number));
    }

    private static String plain(double number) {
        return number == Math.rint(number)
                ? String.format(Locale.ROOT, "%,.0f", number)
                : String.format(Locale.ROOT, "%,.2f", number).replaceAll("0+$", "");
    }

    /** The fields that have a rule, as {@code Event.field}. */
    static List<String> fields() {
        return RULES.keySet().stream().sorted().toList();
    }
}
