package org.sami.spn.analysis;

import static org.sami.spn.analysis.PlanCheckCases.begin;
import static org.sami.spn.analysis.PlanCheckCases.passOn;
import static org.sami.spn.analysis.PlanCheckCases.reading;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.FieldSource;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/** Pairs of plans for the checks of values that are known before a run. */
final class ValueCheckCases {
    private ValueCheckCases() {}

    static NetBuilder watching(Map<String, Value> fields) {
        Map<String, FieldSource> sources = new LinkedHashMap<>();
        fields.forEach((field, value) -> sources.put(field, new FieldSource.Fixed(value)));
        return passOn(begin()).output("go", "Watch", sources, Map.of()).transition("last", "Well");
    }

    private static NetBuilder watching(String field, Value value) {
        return watching(Map.of(field, value));
    }

    private static NetBuilder levels(double low, double critical) {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("low", new RealValue(low));
        fields.put("critical", new RealValue(critical));
        return watching(fields);
    }

    private static NetBuilder gathering(String robot) {
        MapValue at = new MapValue(Map.of(new ProxyValue(robot), GeoPoint.of(45, 10)));
        return passOn(begin())
                .output("go", "Greet", Map.of("name", new FieldSource.Fixed(new TextValue("anna"))), Map.of())
                .output("go", "Gather", Map.of("at", new FieldSource.Fixed(at)), Map.of());
    }

    private static NetBuilder asking(String question) {
        return passOn(begin())
                .output("go", "Approve", Map.of("question", new FieldSource.Fixed(new TextValue(question))), Map.of())
                .transition("last", "Yes");
    }

    private static NetBuilder allocating(Map<String, FieldSource> fields) {
        return passOn(begin().task("T", "Measure", Map.of())).output("go", "ApplyAllocation", fields, Map.of());
    }

    static List<PlanCheckCase> all() {
        List<PlanCheckCase> cases = new ArrayList<>();
        cases.add(PlanCheckCases.of(
                "E-OUT-OF-RANGE", watching("low", new RealValue(-1)), watching("low", new RealValue(0))));
        cases.add(PlanCheckCases.of(
                "E-OUT-OF-RANGE", watching("low", new RealValue(101)), watching("low", new RealValue(100))));
        cases.add(PlanCheckCases.of(
                "W-UNUSUAL-VALUE", watching("every", new DurationValue(0)), watching("every", new DurationValue(100))));
        cases.add(PlanCheckCases.of(
                "W-FRACTION", watching("low", new RealValue(0.3)), watching("low", new RealValue(1))));
        cases.add(PlanCheckCases.of(
                "W-FRACTION", valueOf("@low", new RealValue(0.3)), valueOf("@low", new RealValue(30))));
        cases.add(PlanCheckCases.of("W-NOT-ABOVE", levels(20, 30), levels(30, 20)));
        cases.add(PlanCheckCases.of("W-NOT-ABOVE", levels(20, 20), levels(20.5, 20)));
        cases.add(PlanCheckCases.of(
                "W-UNKNOWN-WORD",
                watching("sensor", new TextValue("temprature")),
                watching("sensor", new TextValue("ctd/temperature"))));
        cases.add(PlanCheckCases.of("W-UNKNOWN-ROBOT", gathering("ana"), gathering("anna")));
        cases.add(PlanCheckCases.of("W-UNKNOWN-ROBOT", gathering("annabel"), gathering("anna2")));
        cases.add(PlanCheckCases.of("W-EMPTY-QUESTION", asking(" "), asking("Go on?")));
        cases.add(PlanCheckCases.of("W-EMPTY-QUESTION", defining(), defining("@v")));
        cases.add(PlanCheckCases.of(
                "E-APPLIES-NOTHING",
                allocating(Map.of()),
                allocating(Map.of("tasks", new FieldSource.FromVariable("@t")))));
        NetBuilder early = reading("@v").variable("@v", ValueType.Simple.REAL);
        NetBuilder late = reading("@v").variable("@v", ValueType.Simple.REAL);
        cases.add(PlanCheckCases.of(
                "W-NOT-YET-WRITTEN",
                needing(early).input("last", "News", Map.of(), Map.of("value", "@v")),
                needing(late).input("first", "News", Map.of(), Map.of("value", "@v"))));
        return cases;
    }

    private static NetBuilder valueOf(String variable, Value value) {
        return passOn(begin())
                .output("go", "Watch", Map.of("low", new FieldSource.FromVariable(variable)), Map.of())
                .transition("last", "Well")
                .variable(variable, ValueType.Simple.REAL, value);
    }

    private static NetBuilder defining(String... variables) {
        List<Value> names = new ArrayList<>();
        for (String variable : variables) {
            names.add(new VariableReference(variable));
        }
        return passOn(begin())
                .output("go", "Define", Map.of("variables", new FieldSource.Fixed(new ListValue(names))), Map.of())
                .variable("@v", ValueType.Simple.REAL);
    }

    /** A robot drives as fast as the variable says: the field must have a value. */
    private static NetBuilder needing(NetBuilder net) {
        return net.output("go", "Drive", Map.of("speed", new FieldSource.FromVariable("@v")), Map.of());
    }
}
