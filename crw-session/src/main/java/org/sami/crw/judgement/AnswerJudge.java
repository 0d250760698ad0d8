package org.sami.crw.judgement;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;
import org.sami.session.api.Judgement.Remark;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/**
 * Judges what is filled in of an answer: values that cannot be, areas and places that boats are not to enter, and what the work takes. Knows values only; on
 * any thread. Takes from under a millisecond to a second or so for a large area.
 */
public final class AnswerJudge {
    private final CrwServices services;

    /**
     * A judge.
     *
     * @param services divide areas as they would be divided
     */
    public AnswerJudge(CrwServices services) {
        this.services = Objects.requireNonNull(services, "services");
    }

    /**
     * Judges a draft.
     *
     * @param boats that would go by it
     */
    public Judgement judge(JudgedQuestion question, List<JudgedBoat> boats, DraftAnswer draft) {
        List<Remark> remarks = new ArrayList<>();
        draft.values().forEach((item, value) -> remarks.addAll(value(item, value, question, draft)));
        Judgement sofar = Judgement.of(remarks);
        if (sofar.refusal().isPresent()) {
            return sofar;
        }
        WorkRemarks work = new WorkRemarks(question, services, boats);
        List<JudgedRequest> all = new ArrayList<>(question.requests());
        all.addAll(question.next());
        for (JudgedRequest request : all) {
            boats.forEach(boat -> HandlerModules.missing(
                            boat.name(), boat.capabilities(), request.type(), request.values(draft))
                    .map(Remark::doubt)
                    .ifPresent(remarks::add));
            remarks.addAll(work.of(request.type(), request.values(draft)));
        }
        draft.option().ifPresent(option -> remarks.addAll(work.ways(List.of(option))));
        return Judgement.of(remarks);
    }

    private static List<Remark> value(String item, Value value, JudgedQuestion question, DraftAnswer draft) {
        List<Remark> remarks = new ArrayList<>();
        for (JudgedRequest request : question.requests()) {
            for (String field : request.fieldsOf(item)) {
                FieldRules.wrong(request.type(), field, value)
                        .map(Remark::refusal)
                        .ifPresent(remarks::add);
            }
        }
        if (value instanceof GeoArea area) {
            remarks.addAll(AreaRemarks.of(item, area, question, draft));
        } else if (value instanceof ListValue list && list.items().stream().anyMatch(GeoArea.class::isInstance)) {
            list.items().stream()
                    .filter(GeoArea.class::isInstance)
                    .map(GeoArea.class::cast)
                    .forEach(area -> remarks.addAll(AreaRemarks.of(item, area, question, draft)));
        } else {
            List<GeoPoint> places = WorkRemarks.places(value);
            remarks.addAll(PlaceRemarks.of(places, question));
        }
        return remarks;
    }
}
