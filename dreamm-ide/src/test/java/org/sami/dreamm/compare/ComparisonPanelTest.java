package org.sami.dreamm.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Point2D;
import java.util.Optional;
import java.util.Set;
import javax.swing.JList;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.palette.Theme;
import org.sami.picture.net.NetMode;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.ui.check.Layout;
import org.sami.ui.look.Look;
import org.sami.ui.net.NetView;

/** Two versions of a plan in a panel as high as it is in a window of 1280 by 800 pixels. */
@Isolated("the look is one for all windows of a process")
class ComparisonPanelTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final String PLAN = "clv-interrupts";

    private DreammContext context;
    private ComparisonPanel panel;

    private void compareAfterRemovalOf(String element) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            Look.apply(Theme.LIGHT, 100);
            context = new DreammContext(
                    BOATS,
                    new ProjectDocument(
                            BOATS.vocabulary(), BOATS.projectOf(PLAN).orElseThrow(), Optional.empty()),
                    Profile.ALL);
            panel = new ComparisonPanel(context);
            Layout.layOut(panel, 785, 335);
            Plan before = context.document().plan(PLAN).orElseThrow();
            context.apply(new RemoveElements(PLAN, Set.of(element)));
            panel.compare(before, "what was saved");
            Layout.layOut(panel, 785, 335);
        });
    }

    @AfterEach
    void close() throws Exception {
        SwingUtilities.invokeAndWait(context::close);
    }

    private NetView net() {
        return Layout.find(panel, "comparison-net", NetView.class).orElseThrow();
    }

    @Test
    void recoveryPartsAreShownWhereTheyDiffer() throws Exception {
        compareAfterRemovalOf("execute");
        assertThat(net().mode()).isEqualTo(NetMode.ALL); // interrupts go with it

        compareAfterRemovalOf("end");
        assertThat(net().mode()).isEqualTo(NetMode.NOMINAL);
    }

    @Test
    void whatAChosenLineIsAboutIsShownAsLargeAsWordsAreRead() throws Exception {
        compareAfterRemovalOf("alarm-button");
        SwingUtilities.invokeAndWait(() -> {
            assertThat(net().zoom()).isLessThan(0.5);
            int edge = panel.differences().stream()
                    .map(Difference::text)
                    .toList()
                    .indexOf(panel.differences().stream()
                            .map(Difference::text)
                            .filter(text -> text.startsWith("The edge "))
                            .findFirst()
                            .orElseThrow());
            Layout.find(panel, "comparison-differences", JList.class)
                    .orElseThrow()
                    .setSelectedIndex(edge);

            assertThat(net().zoom()).isGreaterThanOrEqualTo(0.8);
            Vertex button = net().drawing().vertices().stream()
                    .filter(vertex -> vertex.id().equals("alarm-button"))
                    .findFirst()
                    .orElseThrow();
            Point2D at = net().pixel(button.centre().x(), button.centre().y());
            assertThat(net().canvas().getBounds().contains(at)).isTrue();
        });
    }
}
