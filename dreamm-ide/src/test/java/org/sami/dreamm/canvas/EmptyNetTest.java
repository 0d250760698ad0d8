package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.ui.check.Layout;

class EmptyNetTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    @Test
    void anEmptyPlanSaysWithWhichKeysItIsDrawn() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            DreammContext context = new DreammContext(
                    BOATS,
                    new ProjectDocument(
                            BOATS.vocabulary(), BOATS.projectOf("clv").orElseThrow(), Optional.empty()),
                    Profile.ALL);
            ModelView view = new ModelView(context);
            JTextComponent hint =
                    Layout.find(view, "net-empty", JTextComponent.class).orElseThrow();
            assertThat(hint.isVisible()).isFalse();

            Plan plan = context.editor().plan().orElseThrow();
            Set<String> all = new HashSet<>();
            plan.places().forEach(place -> all.add(place.id()));
            plan.transitions().forEach(transition -> all.add(transition.id()));
            context.apply(new RemoveElements(plan.id(), all));
            assertThat(hint.isVisible()).isTrue();
            assertThat(hint.getText()).contains("P adds a blank place, T a transition");

            context.undo();
            assertThat(hint.isVisible()).isFalse();
            context.close();
        });
    }
}
