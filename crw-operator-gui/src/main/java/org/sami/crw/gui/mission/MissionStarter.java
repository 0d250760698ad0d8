package org.sami.crw.gui.mission;

import java.awt.Component;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.SwingUtilities;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.start.WindowSettings;
import org.sami.crw.sim.run.Parameters;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.Value;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** Starts missions: at once, when what the plan asks is asked as it goes, or with values given beforehand. */
public final class MissionStarter {
    private final OperatorContext context;
    private final WindowSettings settings;

    /**
     * A starter.
     *
     * @param settings keeps the values that were given last
     */
    public MissionStarter(OperatorContext context, WindowSettings settings) {
        this.context = context;
        this.settings = settings;
    }

    /** Starts a mission of a plan; what it asks is asked as it goes. */
    public void start(Plan plan) {
        start(plan, Map.of());
    }

    private void start(Plan plan, Map<String, Value> values) {
        context.tell(context.session().start(plan.id(), plan.title(), values), plan.title() + " has begun");
    }

    /** Asks for values beforehand, those of the last time offered, and starts. */
    void startWithValues(Component over, Project project, Plan plan) {
        Parameters parameters = new Parameters(context.vocabulary(), project, plan);
        Map<String, String> last = new LinkedHashMap<>();
        parameters.describe().forEach(each -> last.put(each.name(), settings.text(key(plan, each.name()))));
        JDialog dialog = new JDialog(SwingUtilities.getWindowAncestor(over), "Start " + plan.title());
        dialog.setName("mission-values-window");
        ParametersForm form = new ParametersForm(parameters, last, values -> {
            dialog.dispose();
            values.forEach((name, text) -> settings.keep(key(plan, name), text));
            values.values().removeIf(String::isBlank);
            start(plan, parameters.read(values));
        });
        int inset = Look.px(Spacing.INSET);
        form.setBorder(BorderFactory.createEmptyBorder(inset, inset, inset, inset));
        dialog.setContentPane(form);
        dialog.getRootPane().setDefaultButton(form.startButton());
        dialog.pack();
        dialog.setLocationRelativeTo(SwingUtilities.getWindowAncestor(over));
        dialog.setVisible(true);
    }

    private static String key(Plan plan, String name) {
        return "value." + plan.id() + "." + name;
    }
}
