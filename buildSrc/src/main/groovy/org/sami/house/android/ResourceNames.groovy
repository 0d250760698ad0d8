package org.sami.house.android

import groovy.xml.XmlSlurper

/**
 * The names of an app's resources, by their kind, and a class R of them without values. The compiler is content with it where aapt, which knows the
 * values, is not installed.
 */
class ResourceNames {
    private static final Map<String, String> KINDS = ['string-array': 'array', 'integer-array': 'array', 'declare-styleable': 'styleable']

    private final Map<String, Set<String>> names = new TreeMap<>()

    /** Reads the resource folders (values, layout, drawable, with any qualifiers) in a folder. */
    ResourceNames(File resources) {
        resources.listFiles().findAll { it.directory }.each { folder ->
            def kind = folder.name.split('-')[0]
            folder.listFiles().findAll { it.file }.each { file ->
                if (kind == 'values') {
                    new XmlSlurper().parse(file).children().each {
                        enter(it.name() == 'item' ? it.@type.text() : KINDS.getOrDefault(it.name(), it.name()), it.@name.text())
                    }
                } else {
                    enter(kind, file.name.substring(0, file.name.indexOf('.')))
                    (file.name.endsWith('.xml') ? file.getText('UTF-8') : '').findAll(/@\+id\/(\w+)/) { enter('id', it[1]) }
                }
            }
        }
    }

    private void enter(String kind, String name) {
        names.computeIfAbsent(kind) { new TreeSet<>() } << name.replace('.', '_')
    }

    /** The names of each kind. */
    Map<String, Set<String>> byKind() {
        names
    }

    /** The names in a source of the class R, as aapt writes it. */
    static Map<String, Set<String>> declared(File source) {
        def found = new TreeMap<String, Set<String>>()
        def kind = ''
        source.eachLine('UTF-8') { line ->
            kind = line.find(/public static final class (\w+) \{/) { it[1] } ?: kind
            line.find(/public static int (\w+)=/) { found.computeIfAbsent(kind) { new TreeSet<>() } << it[1] }
        }
        return found
    }

    /** The source of the class R of a package. */
    String source(String javaPackage) {
        def kinds = names.collect { kind, members ->
            "    public static final class $kind {\n" + members.collect { "        public static int $it;\n" }.join('') + '    }\n'
        }
        "package $javaPackage;\n\npublic final class R {\n${kinds.join('')}}\n"
    }
}
