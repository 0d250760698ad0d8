package org.sami.crw.gui.mission;

import java.awt.Component;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.spn.model.DisabledParts;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.Value;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;
import org.sami.ui.value.ValueEditors;
import org.sami.ui.window.WindowSettings;

/** Starts missions: at once, when what the plan asks is asked as it goes, or with values given beforehand. */
public final class MissionStarter {
    private final OperatorContext context;
    private final WindowSettings settings;
    private final ValueEditors editors;
    private final Consumer<List<Value>> preview;
    private LongConsumer started = mission -> {};

    /**
     * A starter.
     *
     * @param settings keeps the values that were given last
     * @param editors with which values are given
     * @param preview shows the values with which a mission is about to start on the map; none = nothing is about to start
     */
    public MissionStarter(
            OperatorContext context, WindowSettings settings, ValueEditors editors, Consumer<List<Value>> preview) {
        this.context = context;
        this.settings = settings;
        this.editors = editors;
        this.preview = preview;
    }

    /** Calls a listener with the number of each mission that was started with it. */
    void onStarted(LongConsumer listener) {
        started = listener;
    }

    /** Starts a mission of a plan; what it asks is asked as it goes. */
    public void start(Plan plan) {
        start(plan, Map.of());
    }

    private void start(Plan plan, Map<String, Value> values) {
        CompletionStage<Long> begun = context.session().start(plan.id(), plan.title(), values);
        begun.thenAccept(mission -> started.accept(mission));
        context.tell(begun, plan.title() + " has begun" + DisabledParts.remark(plan));
    }

    /** Asks for values beforehand, those of the last time offered, and starts. */
    void startWithValues(Component over, Project project, Plan plan) {
        Parameters parameters = new Parameters(context.vocabulary(), project, plan);
        Set<String> globals = new HashSet<>();
        project.globals().forEach(global -> globals.add(global.name()));
        List<String> names = Stream.concat(parameters.fields().stream(), parameters.variables().stream())
                .filter(name -> !globals.contains(name) && !globals.contains(name.replaceFirst("^@", "")))
                .toList();
        WindowSheet sheet = WindowSheet.in(over);
        ParametersForm form = new ParametersForm(
                parameters,
                names,
                editors,
                last(parameters, plan, names),
                values -> context.session().drafts().judgeStart(plan.id(), values),
                preview,
                values -> {
                    sheet.close();
                    names.forEach(name -> settings.keep(
                            key(plan, name), values.containsKey(name) ? parameters.text(name, values.get(name)) : ""));
                    start(plan, values);
                });
        form.warnOf(plan);
        LookColors.border(form, () -> {
            int inset = Look.px(Spacing.INSET);
            return BorderFactory.createEmptyBorder(0, inset, inset, inset);
        });
        sheet.open(new Sheet("mission-values-window", "Start " + plan.title(), form)
                .over(over) // next to the map, which shows the entries
                .whenClosed(() -> preview.accept(List.of())));
    }

    /** The values of the last time; one that the plan of today does not take is left out. */
    private Map<String, Value> last(Parameters parameters, Plan plan, List<String> names) {
        Map<String, Value> last = new LinkedHashMap<>();
        for (String name : names) {
            String text = settings.text(key(plan, name));
            if (!text.isBlank()) {
                try {
                    last.putAll(parameters.read(Map.of(name, text)));
                } catch (IllegalArgumentException unfit) {
                    settings.keep(key(plan, name), "");
                }
            }
        }
        return last;
    }

    private static String key(Plan plan, String name) {
        return "value." + plan.id() + "." + name;
    }
}
