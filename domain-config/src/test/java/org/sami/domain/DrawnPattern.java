package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Action;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.pattern.Pattern;
import org.sami.spn.pattern.PatternSpot;
import org.sami.spn.pattern.Patterns;
import org.sami.spn.protocol.Activation;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Gathering;
import org.sami.spn.testing.PlayedTeam;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;

/** A plan onto which patterns are drawn: each passes all checks, runs as the pattern says, and is one step to undo. */
abstract class DrawnPattern {
    static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    static final AuthoringLibrary LIBRARY = BOATS.authoring();

    EditHistory history = history(new PlanBuilder("p").build());

    static EditHistory history(Plan plan) {
        return history(new Project("project", "", "crw", List.of(), List.of(), List.of(plan)));
    }

    static EditHistory history(Project project) {
        return new EditHistory(project, BOATS.vocabulary(), 100);
    }

    Plan plan() {
        return history.project().plans().get(0);
    }

    void done(Edit edit) {
        EditResult result = history.apply(edit);
        assertThat(result).as("%s", result).isInstanceOf(EditResult.Done.class);
    }

    static Pattern pattern(String id) {
        return Patterns.of(LIBRARY).stream()
                .filter(p -> p.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    PatternSpot spot(String... selected) {
        return new PatternSpot(history.project(), plan(), Set.of(selected), Mode.NOMINAL, BOATS.vocabulary(), LIBRARY);
    }

    /** Draws a pattern, and sees that it is undone as one. */
    void draw(String pattern, String... selected) {
        PatternSpot spot = spot(selected);
        assertThat(pattern(pattern).refusal(spot)).isEmpty();
        Project before = history.project();
        done(pattern(pattern).edit(spot));
        Project after = history.project();
        history.undo();
        assertThat(history.project()).isEqualTo(before);
        history.redo();
        assertThat(history.project()).isEqualTo(after);
    }

    void first(String event) {
        done(AddEvent.usual(
                "p", event, new EventTarget.Free(Optional.of(new LayoutPoint(60, 200))), Mode.NOMINAL, LIBRARY));
    }

    void behind(String answer, String event) {
        onto(placeBehind(answer), event);
    }

    void onto(String place, String event) {
        AddEvent usual = AddEvent.usual("p", event, new EventTarget.OnVertex(place), Mode.NOMINAL, LIBRARY);
        boolean each = LIBRARY.of(event).stream().anyMatch(s -> s.id().equals(Gathering.EACH.id()));
        done(each ? usual.withSequence(Gathering.EACH.id()) : usual);
    }

    String transition(String answer) {
        List<String> all = plan().transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(answer)))
                .map(t -> t.id())
                .toList();
        return all.get(all.size() - 1);
    }

    String placeBehind(String answer) {
        return plan().outEdgesOf(transition(answer)).get(0).place();
    }

    String place(String output) {
        return plan().places().stream()
                .filter(p -> p.outputs().stream().anyMatch(o -> o.type().equals(output)))
                .findFirst()
                .orElseThrow()
                .id();
    }

    String named(String name) {
        return plan().places().stream()
                .filter(p -> p.name().equals(name))
                .findFirst()
                .orElseThrow()
                .id();
    }

    String transitionNamed(String name) {
        return plan().transitions().stream()
                .filter(t -> t.name().equals(name))
                .findFirst()
                .orElseThrow()
                .id();
    }

    void set(String output, String field, Value value) {
        String event = plan().place(place(output)).orElseThrow().outputs().stream()
                .filter(o -> o.type().equals(output))
                .findFirst()
                .orElseThrow()
                .id();
        done(new FieldEdit.SetField("p", event, field, new FieldSource.Fixed(value)));
    }

    /** What an answer leads to instead of its own place. */
    void lead(String answer, String place) {
        String transition = transition(answer);
        done(new RemoveElements("p", Set.of(placeBehind(answer))));
        done(new EdgeEdit.Connect("p", transition, place, Mode.NOMINAL));
        String edge = plan().outEdgesOf(transition).get(0).id();
        done(new EdgeEdit.SetOutRequirements(
                "p", edge, List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))));
    }

    List<Finding> findings() {
        return PlanChecks.check(history.project(), BOATS.vocabulary());
    }

    PlayedTeam team(int boats, long seed) {
        return new PlayedTeam(history.project(), BOATS.vocabulary(), boats, seed);
    }

    static Map<String, Value> points(Activation asked) {
        Map<Value, Value> points = new LinkedHashMap<>();
        asked.proxies().forEach(p -> points.put(new ProxyValue(p), new GeoPoint(43.6, -79.4, 0)));
        return Map.of("points", new MapValue(points));
    }
}
