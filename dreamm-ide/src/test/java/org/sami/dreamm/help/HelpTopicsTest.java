package org.sami.dreamm.help;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.inspector.InspectorPanel;
import org.sami.dreamm.issues.LiveFindings;
import org.sami.dreamm.profile.Profile;
import org.sami.palette.Theme;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutRequirement;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.look.Look;

@Tag("long")
@Isolated("the look is one for all windows of a process")
@ExtendWith(OnEventThread.class)
class HelpTopicsTest {
    private final List<DreammContext> open = new ArrayList<>();

    @AfterEach
    void close() {
        open.forEach(DreammContext::close);
        Look.apply(Theme.LIGHT, 100);
    }

    private DreammContext open(String domain) {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/" + domain).orThrow();
        DreammContext context = new DreammContext(
                library, new ProjectDocument(library.vocabulary(), library.combined(), Optional.empty()), Profile.ALL);
        open.add(context);
        return context;
    }

    private static HelpTopics topics(DreammContext context) {
        return new HelpTopics(context.vocabulary(), context.additions().library());
    }

    @ParameterizedTest
    @ValueSource(strings = {"crw", "uav"})
    void everyEventAndMarkupOfADomainIsExplainedWithAllItsFields(String domain) {
        DreammContext context = open(domain);

        context.vocabulary().events().values().forEach(type -> {
            HelpTopic topic = topics(context).event(type);
            assertThat(topic.text()).as(type.name()).isNotBlank();
            assertThat(topic.details())
                    .as(type.name())
                    .hasSizeGreaterThanOrEqualTo(type.fields().size());
        });
        context.vocabulary()
                .markups()
                .values()
                .forEach(type -> assertThat(topics(context).markup(type).text())
                        .as(type.name())
                        .isNotBlank());
    }

    @Test
    void everyRequirementOfTheLibraryIsExplainedWithWhichTokensItMeans() {
        DreammContext context = open("crw");

        context.document().project().plans().forEach(plan -> {
            plan.inEdges().stream()
                    .flatMap(edge -> edge.requirements().stream())
                    .map((InRequirement r) -> topics(context).requirement(r))
                    .forEach(topic ->
                            assertThat(topic.details()).as(topic.title()).hasSize(1));
            plan.outEdges().stream()
                    .flatMap(edge -> edge.requirements().stream())
                    .map((OutRequirement r) -> topics(context).requirement(r))
                    .forEach(topic ->
                            assertThat(topic.details()).as(topic.title()).hasSize(1));
        });
    }

    @ParameterizedTest
    @CsvSource({
        "assemble, field-spacing-source, Spacing (m)",
        "assemble, event-0-reset, Assemble Location Request",
        "go, markup-relevant-proxy-remove, Relevant Proxy",
        "go.arrived, inspector-kind-0, All Relevant"
    })
    void innermostThingAroundTheFocusIsExplained(String selected, String focused, String title) {
        DreammContext context = open("crw");
        context.editor().open("station-keep");
        context.editor().select(List.of(selected));
        InspectorPanel panel = new InspectorPanel(
                context, new LiveFindings(context.document(), Runnable::run, Runnable::run, System::nanoTime));
        Component component = Layout.find(panel, focused, JComponent.class).orElseThrow();

        assertThat(HelpCommands.around(component).map(HelpTopic::title)).contains(title);
    }

    @Test
    void selectedEdgeIsExplainedByItsRequirements() {
        DreammContext context = open("crw");
        var plan = context.document().plan("station-keep").orElseThrow();

        plan.inEdges().stream()
                .filter(edge -> !edge.requirements().isEmpty())
                .forEach(edge ->
                        assertThat(topics(context).element(plan, edge.id())).isPresent());
        assertThat(topics(context).element(plan, "go").orElseThrow().title()).isEqualTo("Proxy Goto Point");
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150})
    void noTextOfHelpIsCut(int scale) {
        Look.apply(Theme.LIGHT, scale);
        DreammContext context = open("crw");
        context.vocabulary().events().values().forEach(type -> {
            HelpView view = new HelpView(topics(context).event(type));
            Layout.layOut(view, view.getPreferredSize().width, view.getPreferredSize().height);

            assertThat(TextFit.faults(view)).as(type.name()).isEmpty();
            assertThat(Layout.find(view, "help-kind", JTextArea.class)).isPresent();
        });
    }
}
