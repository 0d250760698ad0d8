package org.sami.spn.edit;

import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;

/**
 * Goes through the ids of vertices in the queries of a plan: in the brackets of {@code m(…)} and {@code enabled(…)}, and after {@code bound}. A name that is no id
 * is the name of a vertex for people, and stays.
 */
final class QueryNames {
    /** A name in quotes or without, then what of its tokens is meant, such as {@code .robots}. */
    private static final Pattern USE = Pattern.compile(
            "(?<before>\\b(?:m|enabled)\\s*\\(\\s*|^\\s*bound\\s+)(?:\"(?<quoted>(?:[^\"\\\\]|\\\\.)*)\"|(?<plain>[\\p{L}\\p{N}_.:-]+))");

    private static final Pattern PLAIN = Pattern.compile("[\\p{L}\\p{N}_:-]+");

    private final Plan plan;
    private final Function<NameUse, String> names;
    private final Set<String> ids;

    QueryNames(Plan plan, Function<NameUse, String> names) {
        this.plan = plan;
        this.names = names;
        ids = plan.queries().isEmpty() ? Set.of() : plan.elementIds();
    }

    List<PlanQuery> replaced() {
        return plan.queries().stream().map(this::replaced).toList();
    }

    private PlanQuery replaced(PlanQuery query) {
        Matcher use = USE.matcher(query.text());
        StringBuilder text = new StringBuilder();
        while (use.find()) {
            String quoted = use.group("quoted");
            String name = quoted == null ? plain(query, use.group("plain")) : quoted(query, quoted);
            use.appendReplacement(text, Matcher.quoteReplacement(use.group("before") + name));
        }
        return query.withText(use.appendTail(text).toString());
    }

    private String quoted(PlanQuery query, String escaped) {
        String id = escaped.replaceAll("\\\\(.)", "$1");
        return ids.contains(id) ? written(renamed(query, id)) : '"' + escaped + '"';
    }

    /** The longest beginning that is an id; what follows its dot stays. */
    private String plain(PlanQuery query, String word) {
        for (int end = word.length(); end > 0; end = word.lastIndexOf('.', end - 1)) {
            String id = word.substring(0, end);
            if (ids.contains(id)) {
                String renamed = renamed(query, id);
                return renamed.equals(id) ? word : written(renamed) + word.substring(end);
            }
        }
        return word;
    }

    private String renamed(PlanQuery query, String id) {
        return names.apply(new NameUse(NameUse.Kind.ELEMENT, id, plan.id(), "", "query \"" + query.name() + "\""));
    }

    private static String written(String id) {
        return PLAIN.matcher(id).matches() ? id : '"' + id.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
