package org.sami.crw.console;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.operator.map.LayerState;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.SensorChannel;
import org.sami.crw.operator.map.SensorLayer;
import org.sami.crw.operator.map.ShownLayer;
import org.sami.crw.sim.run.settings.ValueText;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.NaturalOrder;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Commands about the map: its layers, what sensors measured, and the fence. */
final class MapCommands {
    private static final String ON = "on";
    private static final String OFF = "off";
    private static final String AUTO = "auto";

    private final ConsoleContext context;

    MapCommands(ConsoleContext context) {
        this.context = context;
    }

    List<ConsoleCommand> all() {
        return List.of(
                ConsoleCommand.of(
                        "layers [LAYER on|off|auto]",
                        "Lists the map's layers and why each is on; puts one on or off, or leaves it to markup.",
                        this::layers,
                        words -> words.size() > 1 ? List.of(ON, OFF, AUTO) : layerWords()),
                ConsoleCommand.of(
                        "data [CHANNEL heatmap|contour|threshold [VALUE]|auto]",
                        "Lists what sensors measured; draws one of them so, or leaves it to markup.",
                        this::data,
                        words -> words.size() > 1 ? visualizationWords() : channelWords()),
                ConsoleCommand.of(
                        "fence [AREA|none|project]",
                        "Says where boats are to stay; sets the fence, takes it away, or takes the project's again.",
                        this::fence,
                        words -> List.of("none", "project")));
    }

    private MapSnapshot map() {
        return context.models().map().snapshot();
    }

    // ---- layers

    private void layers(Arguments arguments, Consumer<String> out) {
        if (!arguments.hasNext()) {
            map().layers().forEach(state -> out.accept(describe(state)));
            out.accept(count(map()));
            map().view()
                    .ifPresent(view -> out.accept(String.format(
                            Locale.ROOT,
                            "view %d: %.5f,%.5f to %.5f,%.5f, for %s",
                            view.number(),
                            view.southDeg(),
                            view.westDeg(),
                            view.northDeg(),
                            view.eastDeg(),
                            view.why())));
            Optional.of(map().heldBack()).filter(text -> !text.isEmpty()).ifPresent(out);
            return;
        }
        String word = arguments.next("layer");
        ShownLayer layer = Arrays.stream(ShownLayer.values())
                .filter(one -> word(one).equals(word))
                .findFirst()
                .orElseThrow(() -> new ConsoleFault(
                        "there is no layer '" + word + "'; there are " + String.join(", ", layerWords())));
        String how = arguments.next("state: on, off or auto");
        arguments.end();
        if (!List.of(ON, OFF, AUTO).contains(how)) {
            throw new ConsoleFault("a layer is put on, off or auto, not '" + how + "'");
        }
        context.models().map().show(layer, how.equals(AUTO) ? Optional.empty() : Optional.of(how.equals(ON)));
        out.accept(word + " is " + how);
    }

    private static String describe(LayerState state) {
        String why = state.why().isEmpty() ? "" : ", " + state.why();
        String whose = state.boats().isEmpty()
                ? ""
                : ", of "
                        + String.join(
                                ", ",
                                state.boats().stream()
                                        .sorted(NaturalOrder.INSTANCE)
                                        .toList());
        return word(state.layer()) + "  " + (state.on() ? ON : OFF) + why + whose;
    }

    private String count(MapSnapshot map) {
        return map.boats().size() + " " + context.words().typed("boats") + ", "
                + map.paths().size() + " paths, " + map.areas().size() + " areas, "
                + map.places().size() + " places";
    }

    private static List<String> layerWords() {
        return Arrays.stream(ShownLayer.values()).map(MapCommands::word).toList();
    }

    private static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    // ---- data

    private void data(Arguments arguments, Consumer<String> out) {
        if (!arguments.hasNext()) {
            if (map().channels().isEmpty()) {
                out.accept("no sensor has measured anything yet");
            }
            map().channels()
                    .forEach(channel -> out.accept(channel
                            + map().data().stream()
                                    .filter(layer -> layer.channel().equals(channel))
                                    .map(MapCommands::describe)
                                    .findFirst()
                                    .orElse("  not drawn")));
            return;
        }
        String word = arguments.next("channel");
        SensorChannel channel = map().channels().stream()
                .filter(one -> one.isCalled(word))
                .findFirst()
                .orElseThrow(() -> new ConsoleFault("no sensor has measured '" + word + "'"
                        + (channelWords().isEmpty() ? "" : "; there are " + String.join(", ", channelWords()))));
        String how = arguments.next("way: heatmap, contour, threshold or auto");
        Optional<Visualization> visualization = Arrays.stream(Visualization.values())
                .filter(one -> word(one).equals(how))
                .findFirst();
        if (visualization.isEmpty() && !how.equals(AUTO)) {
            throw new ConsoleFault("data are drawn as heatmap, contour or threshold, or auto, not as '" + how + "'");
        }
        if (visualization.equals(Optional.of(Visualization.THRESHOLD)) && arguments.hasNext()) {
            context.models().map().setThreshold(channel, arguments.real("threshold"));
        }
        arguments.end();
        context.models().map().showData(channel, visualization);
        out.accept(channel + " is drawn: " + how);
    }

    private static String describe(SensorLayer layer) {
        return String.format(
                Locale.ROOT,
                "  %s from %.3g to %.3g %s, %d x %d cells of %.0f m, %s",
                word(layer.visualization()),
                layer.legend().least(),
                layer.legend().greatest(),
                layer.legend().unit(),
                layer.grid().columns(),
                layer.grid().rows(),
                layer.grid().cellM(),
                layer.why());
    }

    private List<String> channelWords() {
        return map().channels().stream().map(SensorChannel::toString).toList();
    }

    private static List<String> visualizationWords() {
        List<String> words = new ArrayList<>(
                Arrays.stream(Visualization.values()).map(MapCommands::word).toList());
        words.add(AUTO);
        return words;
    }

    // ---- the fence

    private void fence(Arguments arguments, Consumer<String> out) {
        if (!arguments.hasNext()) {
            List<String> fences = map().areas().stream()
                    .filter(area -> area.layer() == ShownLayer.FENCE)
                    .map(area -> area.name() + ": " + area.area().outline().size() + " corners")
                    .toList();
            long noGo = map().areas().stream()
                    .filter(area -> area.layer() == ShownLayer.NO_GO)
                    .count();
            out.accept((fences.isEmpty() ? "there is no fence" : fences.get(0)) + "; no-go areas: " + noGo);
            return;
        }
        String word = arguments.next("area");
        arguments.end();
        if (word.equals("none")) {
            context.await(context.inProcess("the fence is set on").fence().remove());
            out.accept("there is no fence now");
        } else if (word.equals("project")) {
            context.await(context.inProcess("the fence is set on").fence().useProject());
            out.accept("the project's fence counts, if it has one");
        } else {
            context.await(context.inProcess("the fence is set on").fence().set(area(word)));
            out.accept("the fence is set");
        }
    }

    private GeoArea area(String word) {
        List<Finding> findings = new ArrayList<>();
        Optional<Value> value = ValueText.parse(
                word, ValueType.Simple.AREA, context.vocabulary().types(), findings);
        if (value.isPresent() && value.get() instanceof GeoArea area) {
            return area;
        }
        throw new ConsoleFault("a fence is " + ValueText.form(ValueType.Simple.AREA) + ", not '" + word + "'");
    }
}
