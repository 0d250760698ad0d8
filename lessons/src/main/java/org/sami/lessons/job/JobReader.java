package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.LessonJson;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.vocabulary.Vocabulary;

/** Reads job files. Every problem is a finding with its place in the file; with one there is no job. */
public final class JobReader {
    private static final String COMPUTED = "computed";

    private final JobFormat format;

    private JobReader(Vocabulary vocabulary) {
        format = new JobFormat(vocabulary);
    }

    /**
     * Reads the job of a course.
     *
     * @return no job where the course has none of that name, or it has errors
     */
    public static Reading<Job> read(Course course, String lesson, String job, Vocabulary vocabulary) {
        String text = course.jobs().get(lesson + "/" + job);
        return text == null
                ? new Reading<>(
                        Optional.empty(),
                        List.of(Finding.error(JobFormat.CODE, "", "There is no job " + lesson + "/" + job)))
                : read(lesson + "/jobs/" + job + ".json", text, vocabulary);
    }

    /**
     * Reads a job from a text.
     *
     * @param file in which it stands, for messages
     */
    public static Reading<Job> read(String file, String text, Vocabulary vocabulary) {
        Reading<JsonNode> tree = LessonJson.read(file, text, JsonNode.class);
        if (tree.result().isEmpty()) {
            return new Reading<>(Optional.empty(), tree.findings());
        }
        JobReader reader = new JobReader(vocabulary);
        Optional<Job> job =
                JsonObjectReader.of(tree.result().get(), "", reader.format).map(reader::job);
        boolean isGood = reader.format.findings().isEmpty();
        return new Reading<>(isGood ? job : Optional.empty(), reader.format.findings()).locatedIn(file, text);
    }

    private Job job(JsonObjectReader m) {
        if (m.integer("formatVersion", 0) != Job.FORMAT_VERSION) {
            m.problem(JobFormat.CODE, "formatVersion", "\"formatVersion\" is " + Job.FORMAT_VERSION);
        }
        String id = m.text("id");
        String start = m.text("start");
        String plan = m.text("plan");
        Job.Solution solution = solution(m);
        String requirements = m.text("requirements", "");
        if (!requirements.isEmpty() && !requirements.equals(COMPUTED)) {
            m.problem(JobFormat.CODE, "requirements", "\"requirements\" is \"" + COMPUTED + "\", or missing");
        }
        Set<String> ignored = new LinkedHashSet<>();
        m.object("findings").ifPresent(findings -> {
            ignored.addAll(findings.texts("ignore"));
            findings.done();
        });
        CaseReader caseReader = new CaseReader(format);
        List<JobCase> cases = m.objects("cases").stream().map(caseReader::read).toList();
        Set<String> names = new LinkedHashSet<>();
        cases.stream()
                .filter(one -> !names.add(one.name()))
                .forEach(one -> m.problem(JobFormat.CODE, "cases", "Two cases are called \"" + one.name() + "\""));
        PredicateReader predicates = new PredicateReader(format, names);
        List<Job.Use> uses = new ArrayList<>();
        for (JsonObjectReader use : m.objects("uses")) {
            predicates
                    .read(use)
                    .ifPresent(predicate -> uses.add(new Job.Use(predicate, use.text("else"), explained(use))));
            use.done();
        }
        List<Job.Mistake> mistakes = new ArrayList<>();
        for (JsonObjectReader mistake : m.objects("mistakes")) {
            List<JobPredicate> when = mistake.node("when")
                    .map(node -> predicates.all(node, mistake.at("when")))
                    .orElse(List.of());
            if (when.isEmpty()) {
                mistake.problem(JobFormat.CODE, "when", "\"when\" says nothing: the mistake would fit every plan");
            }
            mistakes.add(new Job.Mistake(when, mistake.text("say"), explained(mistake)));
            mistake.done();
        }
        List<String> hints = m.texts("hints");
        Optional<Job.Example> example = m.object("example").map(one -> {
            Job.Example read = new Job.Example(one.text("plan"), one.texts("text"));
            one.done();
            return read;
        });
        m.done();
        return new Job(
                id,
                start,
                plan,
                solution,
                requirements.equals(COMPUTED),
                ignored,
                uses,
                cases,
                mistakes,
                hints,
                example);
    }

    private static Optional<String> explained(JsonObjectReader m) {
        return Optional.of(m.text("explained", "")).filter(step -> !step.isEmpty());
    }

    private static Job.Solution solution(JsonObjectReader m) {
        if (m.node("solution").filter(JsonNode::isObject).isEmpty()) {
            return new Job.Solution(m.text("solution"), List.of());
        }
        JsonObjectReader made = m.object("solution").orElseThrow();
        List<JsonNode> script = made.array("script").stream()
                .map(JsonObjectReader.Element::node)
                .toList();
        Job.Solution solution = new Job.Solution(made.text("from"), script);
        made.done();
        return solution;
    }
}
