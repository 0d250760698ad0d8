package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.MixedInitiative;
import org.sami.crw.decision.OfferedOption;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.session.person.Person;
import org.sami.session.person.Right;
import org.sami.spn.json.ValueJson;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;

/** Rows of decisions, for one person. */
final class DecisionRows {
    private static final int MOST_DECISIONS = 200;
    private static final int MOST_OPTIONS = 500;

    private final Map<String, NamedType> types;

    DecisionRows(Map<String, NamedType> types) {
        this.types = types;
    }

    Table table(List<PendingDecision> pending, Person person) {
        Table.Builder table = new Table.Builder("decisions", MOST_DECISIONS);
        for (PendingDecision one : pending) {
            int rank = table.size();
            ObjectNode row = table.row(String.valueOf(one.decision().id()));
            row.put("rank", rank);
            fill(row, one);
            boolean yours = person.mayAnswer(one.decision());
            row.put("yours", yours);
            if (!yours) {
                row.put("whyNot", refusal(person));
            }
        }
        return table.build();
    }

    /** Why a decision is not a person's. */
    static String refusal(Person person) {
        return person.may(Right.ANSWER)
                ? "This question is not among those of " + person.name() + " ("
                        + person.role().word() + ")"
                : "An " + person.role().word() + " answers no questions";
    }

    private void fill(ObjectNode row, PendingDecision pending) {
        DecisionPresentation shown = pending.presentation();
        Decision decision = pending.decision();
        row.put("priority", BoatRows.word(shown.priority()));
        row.put("title", Table.Builder.cut(shown.title()));
        if (decision.mission() != Ids.NONE) {
            row.put("mission", String.valueOf(decision.mission()));
        }
        Table.Builder.put(row, "plan", pending.plan());
        Table.Builder.put(row, "place", pending.place());
        row.put("type", decision.type());
        ArrayNode lines = row.putArray("description");
        shown.description().forEach(line -> lines.add(Table.Builder.cut(line)));
        Table.Builder.ids(row, "boats", shown.boats());
        row.put("opened", pending.openedAtMillis());
        MixedInitiative autonomy = shown.autonomy();
        autonomy.atMillis().ifPresent(at -> row.put("deadline", at).put("autonomy", autonomy.phrase()));
        form(row, shown);
        DecisionMarkups.put(row, pending);
    }

    private void form(ObjectNode row, DecisionPresentation shown) {
        Question question = shown.question();
        if (question instanceof Question.Approve) {
            row.put("form", "yesNo");
        } else if (question instanceof Question.ChooseProxies choose) {
            row.put("form", "boats");
            row.put("min", choose.min());
            row.put("max", Math.min(choose.max(), choose.proxies().size()));
            if (shown.decision().isInterruptChoice()) {
                row.put("reject", true);
            }
            options(row, shown.options());
        } else if (question instanceof Question.ChooseOption) {
            row.put("form", "option");
            row.put("reject", true);
            options(row, shown.options());
        } else if (question instanceof Question.FillIn fillIn) {
            row.put("form", "fields");
            ArrayNode fields = row.putArray("fields");
            fillIn.items().forEach(item -> field(fields.addObject(), item));
        }
    }

    private static void options(ObjectNode row, List<OfferedOption> offered) {
        ArrayNode options = row.putArray("options");
        offered.stream().limit(MOST_OPTIONS).forEach(option -> {
            ObjectNode one = options.addObject()
                    .put("index", option.index())
                    .put("label", Table.Builder.cut(option.label()))
                    .put("detail", Table.Builder.cut(option.detail()))
                    .put("selected", option.selected());
            one.put("value", option.value() instanceof ProxyValue boat ? boat.proxy() : option.label());
            Shapes.of(option.value()).ifPresent(shape -> one.set("shape", shape));
        });
    }

    private void field(ObjectNode field, Question.Item item) {
        field.put("key", item.key())
                .put("type", TypeNames.of(item.type()))
                .put("unit", item.unit())
                .put("help", Table.Builder.cut(item.help()))
                .put("editable", item.editable())
                .put("optional", item.defaultValue().isPresent());
        item.defaultValue().ifPresent(value -> {
            field.set("value", ValueJson.write(value, item.type(), types));
            Shapes.of(value).ifPresent(shape -> field.set("shape", shape));
        });
        if (item.type() instanceof ValueType.Named named
                && types.get(named.name()) instanceof NamedType.Enumeration constants) {
            constants.constants().forEach(field.putArray("choices")::add);
        }
    }
}
