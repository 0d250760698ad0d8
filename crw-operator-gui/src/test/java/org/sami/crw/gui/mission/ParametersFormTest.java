package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.session.api.Judgement;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;
import org.sami.ui.check.Layout;
import org.sami.ui.value.MapMaker;
import org.sami.ui.value.NamedThings;
import org.sami.ui.value.ValueContext;
import org.sami.ui.value.ValueEditors;

class ParametersFormTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Project PROJECT = LIBRARY.projectOf("explore-team").orElseThrow();
    private static final Parameters PARAMETERS = new Parameters(
            LIBRARY.vocabulary(),
            PROJECT,
            PROJECT.plans().stream()
                    .filter(plan -> plan.id().equals("explore-team"))
                    .findFirst()
                    .orElseThrow());

    private final Map<String, Value> started = new HashMap<>();
    private final AtomicReference<List<Value>> previewed = new AtomicReference<>(List.of());

    private final AtomicReference<Function<Map<String, Value>, Judgement>> judge =
            new AtomicReference<>(values -> Judgement.NOTHING);

    private static Judgement says(Judgement.Kind kind, String words) {
        return new Judgement(List.of(new Judgement.Remark(kind, words)));
    }

    @Test
    void whatIsRefusedStartsNothingAndIsSaidAsLongAsItStands() {
        onEventThread(() -> {
            judge.set(values -> values.containsValue(new RealValue(0))
                    ? says(Judgement.Kind.REFUSAL, "0.1 to 10,000 m lie between lanes, not 0")
                    : Judgement.NOTHING);
            ParametersForm form = form(Map.of());
            find(form, "value-start-spacing-given", JCheckBox.class).doClick(0);
            find(form, "value-start-spacing-text", JTextComponent.class).setText("0");

            assertThat(find(form, "mission-values-wrong", JLabel.class).getText())
                    .isEqualTo("▲ 0.1 to 10,000 m lie between lanes, not 0");
            assertThat(form.startButton().isEnabled()).isFalse();

            find(form, "value-start-spacing-text", JTextComponent.class).setText("5");
            assertThat(find(form, "mission-values-wrong", JLabel.class).getText())
                    .isBlank();
            form.startButton().doClick(0);
            assertThat(started).isEqualTo(Map.of("@spacing", new RealValue(5)));
            return null;
        });
    }

    @Test
    void whatIsToBeMindedIsSaidAndStartsAllTheSame() {
        onEventThread(() -> {
            judge.set(values -> says(Judgement.Kind.DOUBT, "34 % of the area is outside the fence"));
            ParametersForm form = form(Map.of());
            find(form, "value-start-spacing-given", JCheckBox.class).doClick(0);
            find(form, "value-start-spacing-text", JTextComponent.class).setText("5");

            assertThat(find(form, "mission-values-doubts", JTextComponent.class).getText())
                    .isEqualTo("△ 34 % of the area is outside the fence");
            form.startButton().doClick(0);
            assertThat(started).isNotEmpty();
            return null;
        });
    }

    @Test
    void whatIsDisabledForTryingIsSaidOfThePlanThatIsToStart() {
        Plan whole = PROJECT.plan("explore-team").orElseThrow();
        String first = whole.transitions().get(0).id();
        Plan tried = whole.withTransitions(whole.transitions().stream()
                .map(each -> each.id().equals(first) ? each.withDisabled(true) : each)
                .toList());
        onEventThread(() -> {
            ParametersForm form = form(Map.of());
            JLabel note = find(form, "mission-values-disabled", JLabel.class);

            form.warnOf(whole);
            assertThat(note.isVisible()).isFalse();

            form.warnOf(tried);
            assertThat(note.isVisible()).isTrue();
            assertThat(note.getText())
                    .isEqualTo("△ Also does what is disabled for trying: "
                            + whole.transitions().get(0).name());
            return null;
        });
    }

    @Test
    void whatIsNotTickedIsNotGiven() {
        onEventThread(() -> {
            ParametersForm form = form(Map.of());

            form.startButton().doClick(0);

            assertThat(started).isEmpty();
            return null;
        });
    }

    @Test
    void aTickedValueMustBeThereAndIsGiven() {
        onEventThread(() -> {
            ParametersForm form = form(Map.of());
            find(form, "value-start-spacing-given", JCheckBox.class).doClick(0);
            assertThat(form.startButton().isEnabled()).isFalse();
            assertThat(find(form, "mission-values-wrong", JLabel.class).getText())
                    .isEqualTo("▲ Spacing: Enter a number, such as 2.5");

            find(form, "value-start-spacing-text", JTextComponent.class).setText("12.5");
            form.startButton().doClick(0);

            assertThat(started).isEqualTo(Map.of("@spacing", new RealValue(12.5)));
            return null;
        });
    }

    @Test
    void whatIsEnteredIsPreviewedAsSoonAsItIsComplete() {
        onEventThread(() -> {
            ParametersForm form = form(Map.of());
            find(form, "value-start-area-given", JCheckBox.class).doClick(0);
            assertThat(previewed.get()).as("nothing is drawn yet").isEmpty();

            find(form, "value-start-area-text", JTextComponent.class)
                    .setText("25.36, 51.53\n25.36, 51.531\n25.361, 51.531");

            assertThat(previewed.get()).hasSize(1).first().isInstanceOf(GeoArea.class);

            find(form, "value-start-area-given", JCheckBox.class).doClick(0);
            assertThat(previewed.get()).isEmpty();
            return null;
        });
    }

    @Test
    void whatWasGivenTheLastTimeIsOffered() {
        onEventThread(() -> {
            Value spacing = PARAMETERS
                    .read(Map.of("@spacing", PARAMETERS.text("@spacing", new RealValue(7))))
                    .get("@spacing");
            ParametersForm form = form(Map.of("@spacing", spacing));
            assertThat(find(form, "value-start-spacing-given", JCheckBox.class).isSelected())
                    .isTrue();

            form.startButton().doClick(0);

            assertThat(started).isEqualTo(Map.of("@spacing", new RealValue(7)));
            return null;
        });
    }

    private ParametersForm form(Map<String, Value> last) {
        ValueEditors editors = new ValueEditors(
                new ComponentChoice(LIBRARY.components(), LIBRARY.vocabulary().types()),
                new ValueContext(LIBRARY.vocabulary().types(), NamedThings.NONE, MapMaker.PLAIN));
        return new ParametersForm(
                PARAMETERS,
                List.of("@area", "@spacing"),
                editors,
                last,
                values -> CompletableFuture.completedFuture(judge.get().apply(values)),
                previewed::set,
                started::putAll);
    }

    private static <T extends java.awt.Component> T find(ParametersForm form, String name, Class<T> type) {
        return Layout.find(form, name, type).orElseThrow(() -> new AssertionError("there is no " + name));
    }
}
