package org.sami.ui.value;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import javax.swing.JComponent;
import org.sami.spn.component.ComponentLibrary;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.ui.map.MapView;

/** What builds each component that a domain may declare, by the name that {@code components.json} gives it. */
public final class ComponentBuilders {
    private static final Set<String> WIDGETS =
            Set.of("FilterBar", "OptionPreview", "ProxyLayer", "ProxyStateLabels", "PathLayer", "ReadingLayer");

    private static final Map<String, BiFunction<ComponentRequest, ValueContext, ValueEditor>> BUILDERS = builders();

    private ComponentBuilders() {}

    private static Map<String, BiFunction<ComponentRequest, ValueContext, ValueEditor>> builders() {
        Map<String, BiFunction<ComponentRequest, ValueContext, ValueEditor>> all = new LinkedHashMap<>();
        all.put("TextField", (request, context) -> new TextEditor(request.field(), new PlainText()));
        all.put("NumberField", (request, context) -> number(request.field()));
        all.put("DurationField", (request, context) -> new TextEditor(request.field(), new DurationText()));
        all.put("YesNoButtons", (request, context) -> new YesNoEditor(request.field()));
        all.put("ChoiceList", ComponentBuilders::choiceList);
        all.put("ProxyList", ComponentBuilders::robots);
        all.put("TaskList", (request, context) -> named(request, context, NamedThings::tasks));
        all.put("VariableList", (request, context) -> named(request, context, NamedThings::variables));
        all.put("PlanList", (request, context) -> named(request, context, NamedThings::plans));
        all.put("Map", ComponentBuilders::map);
        all.put("OptionPager", (request, context) -> solutions(request, context, SolutionDetails.Format.SEQUENTIAL));
        all.put("OptionTabs", (request, context) -> solutions(request, context, SolutionDetails.Format.TABS));
        all.put("OptionStack", (request, context) -> solutions(request, context, SolutionDetails.Format.STACKED));
        all.put("AllocationTable", ComponentBuilders::allocation);
        return Collections.unmodifiableMap(all);
    }

    /** The names of the components that can be built. */
    public static Set<String> components() {
        return BUILDERS.keySet();
    }

    /** The names of the widgets that can be put on components. */
    public static Set<String> widgets() {
        return WIDGETS;
    }

    /** Says in a sentence each what a domain declares and nobody builds, and what is built and it does not declare. */
    public static List<String> differences(ComponentLibrary library) {
        List<String> all = new ArrayList<>();
        compare(
                "component",
                components(),
                library.components().stream().map(c -> c.name()).toList(),
                all);
        compare(
                "widget",
                widgets(),
                library.widgets().stream().map(w -> w.name()).toList(),
                all);
        return all;
    }

    private static void compare(String kind, Set<String> built, List<String> declared, List<String> all) {
        declared.stream()
                .filter(name -> !built.contains(name))
                .forEach(name -> all.add("The " + kind + " " + name + " is declared, and nothing builds it"));
        built.stream()
                .filter(name -> !declared.contains(name))
                .forEach(name -> all.add("The " + kind + " " + name + " can be built, and is not declared"));
    }

    /** The component of that name; empty where nothing builds it. */
    static Optional<ValueEditor> build(String component, ComponentRequest request, ValueContext context) {
        return Optional.ofNullable(BUILDERS.get(component)).map(builder -> builder.apply(request, context));
    }

    private static ValueEditor number(ValueField field) {
        return new TextEditor(field, new NumberText(field.type() == ValueType.Simple.INTEGER, field.unit()));
    }

    private static ValueEditor choiceList(ComponentRequest request, ValueContext context) {
        ValueType type = request.field().type();
        boolean list = type instanceof ValueType.ListOf;
        ValueType element = list ? ((ValueType.ListOf) type).element() : type;
        List<ChoiceRow> constants = element instanceof ValueType.Named named
                        && context.declarations().get(named.name()) instanceof NamedType.Enumeration declared
                ? declared.constants().stream()
                        .map(constant -> new ChoiceRow(
                                new EnumValue(declared.name(), constant), ValueSummary.ofConstant(constant), ""))
                        .toList()
                : List.of();
        if (request.offer().isEmpty() && constants.isEmpty()) { // texts that are only shown
            return new RepeatedEditor(request.field(), part -> new TextEditor(part, new PlainText()));
        }
        return chooser(request, context, constants, list);
    }

    /** Robots are chosen from those that are known; where others can be named, they are typed as well. */
    private static ValueEditor robots(ComponentRequest request, ValueContext context) {
        NamedThings names = context.names();
        if (request.offer().isPresent() || !names.takesOtherRobots()) {
            return named(request, context, NamedThings::proxies);
        }
        return request.field().type() instanceof ValueType.ListOf
                ? new RepeatedEditor(request.field(), part -> new RobotNameEditor(part, names.proxies()))
                : new RobotNameEditor(request.field(), names.proxies());
    }

    private static ValueEditor named(
            ComponentRequest request, ValueContext context, Function<NamedThings, List<ChoiceRow>> known) {
        boolean list = request.field().type() instanceof ValueType.ListOf;
        return chooser(request, context, known.apply(context.names()), list);
    }

    private static ValueEditor chooser(
            ComponentRequest request, ValueContext context, List<ChoiceRow> known, boolean list) {
        boolean filtered = request.wants("FilterBar");
        if (request.offer().isEmpty()) {
            return new ListChooser(request.field(), list ? Offer.any(known) : Offer.one(known), list, filtered);
        }
        Offer offer = context.names().known(request.offer().get());
        return new ListChooser(request.field(), offer, !offer.single(), filtered);
    }

    private static ValueEditor map(ComponentRequest request, ValueContext context) {
        if (request.offer().isPresent()) {
            return chooser(request, context, List.of(), true);
        }
        Optional<PlacesText> form = PlacesText.of(request.field().type());
        if (form.isEmpty()) {
            return new SolutionView(request.field(), context.names()::ways);
        }
        return form.get()
                .shape()
                .<ValueEditor>map(shape -> new PlaceEditor(request.field(), shape, form.get(), context.maps()))
                .orElseGet(() -> new TextEditor(request.field(), form.get()));
    }

    private static Optional<JComponent> preview(ComponentRequest request, ValueContext context, Value solution) {
        if (!request.wants("OptionPreview")) {
            return Optional.empty();
        }
        MapView map = context.maps().make();
        map.setInForm(true);
        NamedThings names = context.names();
        new PlacesOnMap(map, request.field().componentName("preview"), names::mark, names.ways(solution))
                .show(List.of(solution));
        map.fitAll();
        return Optional.of(map);
    }

    private static ValueEditor solutions(
            ComponentRequest request, ValueContext context, SolutionDetails.Format format) {
        if (request.offer().isEmpty()) {
            return new RepeatedEditor(request.field(), part -> new SolutionView(part, context.names()::ways));
        }
        Offer offer = request.offer().get();
        return new SolutionChooser(
                request.field(),
                offer,
                new SolutionDetails(
                        request.field(),
                        format,
                        offer.values(),
                        solution -> preview(request, context, solution),
                        context.names()::ways));
    }

    private static ValueEditor allocation(ComponentRequest request, ValueContext context) {
        if (request.offer().isPresent()) {
            return chooser(request, context, List.of(), true);
        }
        return request.field().type() instanceof ValueType.MapOf
                ? new AssignmentTable(
                        request.field(),
                        context.names().tasks(),
                        context.names().proxies())
                : new SolutionView(request.field(), context.names()::ways);
    }
}
